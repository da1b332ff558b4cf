/// @file
/// The broadphases of Bullet's worlds that rows compare.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace cellsweep::bench {

struct Contender {
  std::string_view name;
  std::function<std::unique_ptr<btBroadphaseInterface>()> make;
};

/// Bullet's own tree first, and engine `stream` on one thread, with the margin of Bullet's tree, and on as
/// many threads as pay.
const std::vector<Contender>& contenders();

/// Each of them so many times, in turns: those that are compared are measured one after the other, as a
/// machine that others share takes half as long again for minutes at a time.
void for_each_turn(int turns, const std::function<void(const Contender&)>& register_row);

}  // namespace cellsweep::bench
