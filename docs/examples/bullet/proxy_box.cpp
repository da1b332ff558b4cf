#include "proxy_box.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

float at_most(btScalar value) {
  const auto rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float at_least(btScalar value) {
  return -at_most(-value);
}

}  // namespace

cellsweep::Aabb box_around(const btVector3& low, const btVector3& high) {
  return {{at_most(low.x()), at_most(low.y()), at_most(low.z())},
          {at_least(high.x()), at_least(high.y()), at_least(high.z())}};
}

cellsweep::BodyFilter filter_of(const btBroadphaseProxy& proxy) {
  constexpr int kStatic = btBroadphaseProxy::StaticFilter;
  const bool is_static =
      proxy.m_collisionFilterGroup == kStatic && (proxy.m_collisionFilterMask & kStatic) == 0;
  return {.category = static_cast<std::uint32_t>(proxy.m_collisionFilterGroup),
          .mask = static_cast<std::uint32_t>(proxy.m_collisionFilterMask),
          .is_static = is_static};
}
