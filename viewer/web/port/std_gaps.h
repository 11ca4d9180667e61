#pragma once

// What the C++ library of Debian 12's emscripten (libc++ 13) lacks of C++20. Included before every
// file of the web build (cmake/web.cmake), and nowhere else. Goes when Debian 12 goes.

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <compare>
#include <cstddef>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <ranges>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const auto answer = fast_float::from_chars(first, last, value);
  return {answer.ptr, answer.ec};
}

inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto written = fmt::format_to_n(first, static_cast<size_t>(last - first), "{}", value);
  if (written.size > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  return {written.out, errc{}};
}

inline strong_ordering operator<=>(const string& a, const string& b) { return a.compare(b) <=> 0; }

template <class T>
strong_ordering operator<=>(const vector<T>& a, const vector<T>& b) {
  for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
    if (a[i] < b[i]) return strong_ordering::less;
    if (b[i] < a[i]) return strong_ordering::greater;
  }
  return a.size() <=> b.size();
}

template <class T, size_t N>
auto operator<=>(const array<T, N>& a, const array<T, N>& b) -> decltype(a[0] <=> b[0]) {
  for (size_t i = 0; i < N; ++i) {
    if (const auto order = a[i] <=> b[i]; order != 0) return order;
  }
  return decltype(a[0] <=> b[0])::equivalent;
}

template <class T>
strong_ordering operator<=>(const shared_ptr<T>& a, const shared_ptr<T>& b) {
  return a.get() < b.get()   ? strong_ordering::less
         : b.get() < a.get() ? strong_ordering::greater
                             : strong_ordering::equal;
}

namespace chrono {
template <class Rep, class Period>
constexpr strong_ordering operator<=>(const duration<Rep, Period>& a,
                                      const duration<Rep, Period>& b) {
  return a.count() <=> b.count();
}
template <class Clock, class Duration>
constexpr strong_ordering operator<=>(const time_point<Clock, Duration>& a,
                                      const time_point<Clock, Duration>& b) {
  return a.time_since_epoch() <=> b.time_since_epoch();
}
}  // namespace chrono

/// A page has one thread: what another one would do is done when it is started.
class jthread {
 public:
  jthread() = default;
  template <class Function, class... Arguments>
  explicit jthread(Function&& function, Arguments&&... arguments) {
    std::invoke(std::forward<Function>(function), std::forward<Arguments>(arguments)...);
  }
  void join() {}
  bool joinable() const { return false; }
};

namespace ranges {

template <class Range, class Test, class Projection = identity>
bool any_of(Range&& range, Test test, Projection projection = {}) {
  for (auto&& one : range) {
    if (std::invoke(test, std::invoke(projection, one))) return true;
  }
  return false;
}
template <class Range, class Test, class Projection = identity>
bool all_of(Range&& range, Test test, Projection projection = {}) {
  for (auto&& one : range) {
    if (!std::invoke(test, std::invoke(projection, one))) return false;
  }
  return true;
}
template <class Range, class Test, class Projection = identity>
bool none_of(Range&& range, Test test, Projection projection = {}) {
  return !ranges::any_of(range, std::move(test), std::move(projection));
}
template <class Range, class Test, class Projection = identity>
auto find_if(Range&& range, Test test, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), [&](auto&& one) {
    return static_cast<bool>(std::invoke(test, std::invoke(projection, one)));
  });
}
template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& one) { return std::invoke(projection, one) == value; });
}
template <class Range, class Value>
auto count(Range&& range, const Value& value) {
  return std::count(std::begin(range), std::end(range), value);
}
template <class Range, class Test>
auto count_if(Range&& range, Test test) {
  return std::count_if(std::begin(range), std::end(range), test);
}
template <class Range, class Value>
void replace(Range&& range, const Value& from, const Value& to) {
  std::replace(std::begin(range), std::end(range), from, to);
}
template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}
template <class Range, class Out>
auto copy(Range&& range, Out out) {
  struct Answer {
    Out out;
  };
  return Answer{std::copy(std::begin(range), std::end(range), out)};
}
template <class Range, class Out, class Function>
void transform(Range&& range, Out out, Function function) {
  std::transform(std::begin(range), std::end(range), out, [&](auto&& one) {
    return std::invoke(function, std::forward<decltype(one)>(one));
  });
}
template <class A, class B, class Test = std::equal_to<>, class ProjectA = identity,
          class ProjectB = identity>
bool equal(A&& a, B&& b, Test test = {}, ProjectA project_a = {}, ProjectB project_b = {}) {
  return std::equal(
      std::begin(a), std::end(a), std::begin(b), std::end(b), [&](auto&& one, auto&& other) {
        return std::invoke(test, std::invoke(project_a, one), std::invoke(project_b, other));
      });
}

template <class Order, class Projection>
auto projected(Order& order, Projection& projection) {
  return [&](auto&& a, auto&& b) {
    return std::invoke(order, std::invoke(projection, a), std::invoke(projection, b));
  };
}
template <class Range, class Order = std::less<>, class Projection = identity>
void sort(Range&& range, Order order = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), projected(order, projection));
}
template <class Range, class Order = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Order order = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), projected(order, projection));
}
template <class Range, class Order = std::less<>, class Projection = identity>
bool is_sorted(Range&& range, Order order = {}, Projection projection = {}) {
  return std::is_sorted(std::begin(range), std::end(range), projected(order, projection));
}
template <class Range, class Order = std::less<>>
void push_heap(Range&& range, Order order = {}) {
  std::push_heap(std::begin(range), std::end(range), order);
}
template <class Range, class Order = std::less<>>
void pop_heap(Range&& range, Order order = {}) {
  std::pop_heap(std::begin(range), std::end(range), order);
}
template <class Range, class Value, class Order = std::less<>, class Projection = identity>
auto lower_bound(Range&& range, const Value& value, Order order = {}, Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](auto&& one, const Value& wanted) {
                            return std::invoke(order, std::invoke(projection, one), wanted);
                          });
}
template <class Range, class Value, class Order = std::less<>, class Projection = identity>
auto upper_bound(Range&& range, const Value& value, Order order = {}, Projection projection = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value,
                          [&](const Value& wanted, auto&& one) {
                            return std::invoke(order, wanted, std::invoke(projection, one));
                          });
}
template <class Range, class Value, class Order = std::less<>, class Projection = identity>
bool binary_search(Range&& range, const Value& value, Order order = {},
                   Projection projection = {}) {
  const auto at = ranges::lower_bound(range, value, order, projection);
  return at != std::end(range) && !std::invoke(order, value, std::invoke(projection, *at));
}
template <class Range, class Test, class Projection = identity>
auto partition_point(Range&& range, Test test, Projection projection = {}) {
  return std::partition_point(std::begin(range), std::end(range), [&](auto&& one) {
    return static_cast<bool>(std::invoke(test, std::invoke(projection, one)));
  });
}

}  // namespace ranges
}  // namespace std
