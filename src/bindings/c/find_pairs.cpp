#include "cellsweep/find_pairs.h"

#include <memory>
#include <utility>

#include "bindings/c/call.h"
#include "bindings/c/objects.h"
#include "bindings/c/options.h"
#include "bindings/c/views.h"

using namespace cellsweep;
using namespace cellsweep::c;

namespace {

/// What each call is given, as C++ has it.
struct Search {
  explicit Search(const cellsweep_find_options* given) { status = read(given); }

  Status read(const cellsweep_find_options* given) {
    cellsweep_find_options from;
    if (Status read = read_options(given, from); !read.ok()) return read;
    const auto executor = executor_of(from.executor);
    if (!executor) return executor.status();
    const Result<VectorIsa> isa = isa_of(from.isa);
    if (!isa) return isa.status();
    options = {.threads = from.threads, .executor = *executor, .isa = *isa, .max_pairs = from.max_pairs};
    return {};
  }

  Status status;
  FindPairsOptions options{};
};

/// `find(view, options)` for one set.
template <class Find>
Status search(cellsweep_boxes boxes, const cellsweep_find_options* given, const Find& find) {
  const Search call(given);
  if (!call.status.ok()) return call.status;
  const Result<BoxView> view = view_of(boxes);
  return view ? find(*view, call.options) : view.status();
}

/// `find(first, second, options)` for two.
template <class Find>
Status search(cellsweep_boxes first, cellsweep_boxes second, const cellsweep_find_options* given,
              const Find& find) {
  return search(first, given, [&](const BoxView& a, const FindPairsOptions& options) {
    const Result<BoxView> b = view_of(second);
    return b ? find(a, *b, options) : b.status();
  });
}

Status keep(Result<std::vector<Pair>> found, cellsweep_pair_list& list) {
  if (!found) return found.status();
  list.pairs = std::move(*found);
  list.cross_pairs = {};
  return {};
}

Status keep(Result<std::vector<CrossPair>> found, cellsweep_pair_list& list) {
  if (!found) return found.status();
  list.cross_pairs = std::move(*found);
  list.pairs = {};
  return {};
}

Status keep(const Result<std::uint64_t>& counted, std::uint64_t& count) {
  if (counted) count = *counted;
  return counted.status();
}

}  // namespace

cellsweep_status cellsweep_pair_list_create(cellsweep_pair_list** made, cellsweep_failure* failure) {
  return call(failure, {{made, "made"}}, [&] {
    *made = std::make_unique<cellsweep_pair_list>().release();
    return Status{};
  });
}

void cellsweep_pair_list_destroy(cellsweep_pair_list* list) {
  delete list;
}

const cellsweep_pair* cellsweep_listed_pairs(const cellsweep_pair_list* list, size_t* count) {
  const bool is_cross = list != nullptr && list->pairs.empty();
  if (count != nullptr) *count = list == nullptr ? 0 : list->pairs.size() + list->cross_pairs.size();
  if (list == nullptr) return nullptr;
  return is_cross ? seen_as<const cellsweep_pair>(list->cross_pairs.data())
                  : seen_as<const cellsweep_pair>(list->pairs.data());
}

cellsweep_status cellsweep_find_pairs(cellsweep_boxes boxes, const cellsweep_find_options* options,
                                      cellsweep_pair_list* list, cellsweep_failure* failure) {
  return call(failure, {{list, "list"}}, [&] {
    return search(boxes, options, [&](const BoxView& view, const FindPairsOptions& with) {
      return keep(find_pairs(view, with), *list);
    });
  });
}

cellsweep_status cellsweep_find_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                              const cellsweep_find_options* options,
                                              cellsweep_pair_list* list, cellsweep_failure* failure) {
  return call(failure, {{list, "list"}}, [&] {
    return search(first, second, options,
                  [&](const BoxView& a, const BoxView& b, const FindPairsOptions& with) {
                    return keep(find_pairs(a, b, with), *list);
                  });
  });
}

cellsweep_status cellsweep_count_pairs(cellsweep_boxes boxes, const cellsweep_find_options* options,
                                       uint64_t* count, cellsweep_failure* failure) {
  return call(failure, {{count, "count"}}, [&] {
    return search(boxes, options, [&](const BoxView& view, const FindPairsOptions& with) {
      return keep(count_pairs(view, with), *count);
    });
  });
}

cellsweep_status cellsweep_count_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                               const cellsweep_find_options* options, uint64_t* count,
                                               cellsweep_failure* failure) {
  return call(failure, {{count, "count"}}, [&] {
    return search(first, second, options,
                  [&](const BoxView& a, const BoxView& b, const FindPairsOptions& with) {
                    return keep(count_pairs(a, b, with), *count);
                  });
  });
}

cellsweep_status cellsweep_visit_pairs(cellsweep_boxes boxes, const cellsweep_find_options* options,
                                       cellsweep_pair_visitor visit, void* context,
                                       cellsweep_failure* failure) {
  const auto see = [&](Pair pair) { return visit(context, {pair.a, pair.b}); };
  return call(failure, {{reinterpret_cast<void*>(visit), "visit"}}, [&] {
    return search(boxes, options, [&](const BoxView& view, const FindPairsOptions& with) {
      return visit_pairs(view, FunctionRef<bool(Pair)>(see), with);
    });
  });
}

cellsweep_status cellsweep_visit_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                               const cellsweep_find_options* options,
                                               cellsweep_pair_visitor visit, void* context,
                                               cellsweep_failure* failure) {
  const auto see = [&](CrossPair pair) { return visit(context, {pair.a, pair.b}); };
  return call(failure, {{reinterpret_cast<void*>(visit), "visit"}}, [&] {
    return search(first, second, options,
                  [&](const BoxView& a, const BoxView& b, const FindPairsOptions& with) {
                    return visit_pairs(a, b, FunctionRef<bool(CrossPair)>(see), with);
                  });
  });
}
