/// @file
/// Rays and boxes that the broadphase of a world of Bullet is asked for.
#pragma once

namespace cellsweep::bench {

/// Rows `bullet/rays/...` and `bullet/boxes/...`: the time of one question, and how many proxies it met, in a
/// pile of 20,000 cubes that fell for half a second. Bullet's btSimpleBroadphase, which looks at all boxes,
/// is beside the contenders.
void register_questions();

}  // namespace cellsweep::bench
