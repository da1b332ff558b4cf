/// @file
/// Rays and boxes that the broadphase of a world of Bullet is asked for.
#pragma once

namespace cellsweep::bench {

/// Rows `bullet/rays/...` and `bullet/boxes/...`: the time of one question, and how many proxies it met, in a
/// pile of 20,000 cubes that fell for half a second. A ray goes from one point of the pile to another, a box
/// is four wide. What is made for the first question is in the time.
void register_questions();

}  // namespace cellsweep::bench
