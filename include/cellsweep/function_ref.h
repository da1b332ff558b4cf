/// @file
/// A callable that is called before the call that takes it returns: no copy, no memory.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace cellsweep {

/// What a reference of that type can be made of: what can be called so, and is not one itself.
template <class Callable, class Reference, class Answer, class... Arguments>
concept ReferredTo = !std::same_as<std::remove_cvref_t<Callable>, Reference> &&
                     std::is_invocable_r_v<Answer, Callable&, Arguments...>;

template <class Signature>
class FunctionRef;

/// Refers to what it was made of, which must outlive it: to be a parameter, and nothing else.
template <class Answer, class... Arguments>
class FunctionRef<Answer(Arguments...)> {
 public:
  template <ReferredTo<FunctionRef, Answer, Arguments...> Callable>
  // NOLINTNEXTLINE(bugprone-forwarding-reference-overload): a copy is not referred to.
  FunctionRef(Callable&& callable)
      : callable_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* of, Arguments... arguments) -> Answer {
          return (*static_cast<std::add_pointer_t<Callable>>(of))(std::forward<Arguments>(arguments)...);
        }) {}

  Answer operator()(Arguments... arguments) const {
    return call_(callable_, std::forward<Arguments>(arguments)...);
  }

 private:
  void* callable_;
  Answer (*call_)(void*, Arguments...);
};

}  // namespace cellsweep
