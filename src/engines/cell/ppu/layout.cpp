#include "engines/cell/ppu/layout.h"

#include "base/text.h"

namespace cellsweep::cell {

LocalStoreMap make_local_store_map(std::string engine, const LocalStoreBudget& budget,
                                   const BufferList& buffers, std::uint64_t bodies) {
  LocalStoreMap map{std::move(engine), bodies, budget.limit, {}};
  map.parts = {{"code", budget.code}, {"data", budget.data}, {"stack", budget.stack}};
  for (LocalStorePart& buffer : buffers(bodies)) map.parts.push_back(std::move(buffer));
  return map;
}

std::uint64_t bodies_that_fit_local_store(const LocalStoreBudget& budget, const BufferList& buffers,
                                          std::uint64_t most) {
  const auto fits = [&](std::uint64_t bodies) {
    return make_local_store_map("", budget, buffers, bodies).fits();
  };
  if (fits(most)) return most;
  std::uint64_t good = 0;
  std::uint64_t bad = most;
  while (bad - good > 1) {
    const std::uint64_t middle = good + (bad - good) / 2;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

std::string describe(const LocalStoreMap& map) {
  std::string words;
  for (const LocalStorePart& part : map.parts)
    words += text(words.empty() ? "" : ", ", part.name, " ", part.bytes);
  words += text("; together ", map.used());
  if (map.limit == 0) return words + " bytes without a limit";
  if (map.fits()) return words + text(" of ", map.limit, " bytes, ", map.limit - map.used(), " free");
  return words + text(" of ", map.limit, " bytes, ", map.used() - map.limit, " too many");
}

Result<Capacity> local_store_capacity(std::string engine, const LocalStoreBudget& budget,
                                      const BufferList& buffers, std::uint64_t most, std::string why_most) {
  const std::uint64_t bodies = bodies_that_fit_local_store(budget, buffers, most);
  if (bodies == most) return Capacity{most, "", std::move(why_most)};
  const LocalStoreMap too_many = make_local_store_map(std::move(engine), budget, buffers, bodies + 1);
  std::string reason =
      text("the local store of an SPE would hold, for ", bodies + 1, " bodies: ", describe(too_many));
  if (bodies > 0) return Capacity{bodies, "local_store", std::move(reason)};
  return Status::over_capacity(
      text(too_many.engine, " cannot hold a single body: ", reason, "; raise local_store."), too_many.used(),
      too_many.limit, "local_store");
}

}  // namespace cellsweep::cell
