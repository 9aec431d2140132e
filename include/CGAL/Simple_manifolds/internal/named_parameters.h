// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_SIMPLE_MANIFOLDS_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Simple_manifolds/Visitor.h>
#include <CGAL/Simple_manifolds/internal/concepts.h>
#include <CGAL/Simple_manifolds/parameters.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// How all functions of the package read their named parameters. CGAL's get_parameter_reference() returns a copy
// of what can be copied, and a reference to this copy dangles; parameter() returns what is in the pack itself.

// What a parameter is for its reader: what std::ref() and std::cref() refer to, else the value in the pack.
template <class T>
const T& unwrapped(const T& value)
{
  return value;
}
template <class T>
T& unwrapped(const std::reference_wrapper<T>& reference)
{
  return reference;
}

// The name by which users call a parameter.
template <class Tag>
constexpr std::string_view name_of(Tag)
{
  return {};
}
constexpr std::string_view name_of(CGAL::internal_np::vertex_point_t) { return "vertex_point_map"; }
constexpr std::string_view name_of(CGAL::internal_np::visitor_t) { return "visitor"; }
constexpr std::string_view name_of(CGAL::internal_np::use_binary_mode_t) { return "use_binary_mode"; }
#define CGAL_SIMPLE_MANIFOLDS_NAME_OF(name)                                                                  \
  constexpr std::string_view name_of(internal_np::name##_t) { return #name; }
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_PARAMETER(CGAL_SIMPLE_MANIFOLDS_NAME_OF)
#undef CGAL_SIMPLE_MANIFOLDS_NAME_OF

// Whether a name is one of those in a list such as "energy, effort".
constexpr bool is_listed(std::string_view name, std::string_view names)
{
  for (std::size_t begin = 0; begin < names.size();) {
    const std::size_t end = (std::min)(names.find(", ", begin), names.size());
    if (names.substr(begin, end - begin) == name) return true;
    begin = end + 2;
  }
  return false;
}

// A pack of named parameters: one of them, and the rest.
template <class Pack>
struct Parameter_pack;

template <class T, class Tag, class Base>
struct Parameter_pack<CGAL::internal_np::Named_params_impl<T, Tag, Base>> {
  static constexpr bool is_last = std::is_same_v<Base, CGAL::internal_np::No_property>;

  template <class Wanted>
  static constexpr bool has()
  {
    if constexpr (std::is_same_v<Tag, Wanted>)
      return true;
    else if constexpr (is_last)
      return false;
    else
      return Parameter_pack<typename Base::base>::template has<Wanted>();
  }

  template <class Wanted>
  static auto& get(const CGAL::internal_np::Named_params_impl<T, Tag, Base>& pack)
  {
    if constexpr (std::is_same_v<Tag, Wanted>)
      return unwrapped(pack.v);
    else
      return Parameter_pack<typename Base::base>::template get<Wanted>(pack);
  }

  static constexpr bool are_listed(std::string_view names)
  {
    bool result = std::is_same_v<Tag, CGAL::internal_np::all_default_t> || is_listed(name_of(Tag()), names);
    if constexpr (!is_last) result = result && Parameter_pack<typename Base::base>::are_listed(names);
    return result;
  }
};

template <class NamedParameters, class = void>
inline constexpr bool is_parameter_pack = false;
template <class NamedParameters>
inline constexpr bool is_parameter_pack<NamedParameters, std::void_t<typename NamedParameters::base>> = true;

template <class NamedParameters>
constexpr bool are_listed(std::string_view names)
{
  if constexpr (is_parameter_pack<NamedParameters>)
    return Parameter_pack<typename NamedParameters::base>::are_listed(names);
  else
    return false;
}

// Whether a parameter is given.
template <class Tag, class NamedParameters>
inline constexpr bool has_parameter = Parameter_pack<typename NamedParameters::base>::template has<Tag>();

// A parameter that is given, as a reference that lives as long as the pack (or as what std::ref() refers to).
template <class NamedParameters, class Tag>
auto& parameter(const NamedParameters& np, Tag)
{
  return Parameter_pack<typename NamedParameters::base>::template get<Tag>(np);
}

// The same, or the variable `otherwise` where it is not given. A value such as 1e-6 is returned as a value.
template <class NamedParameters, class Tag, class T>
decltype(auto) parameter(const NamedParameters& np, Tag tag, T& otherwise)
{
  if constexpr (has_parameter<Tag, NamedParameters>)
    return parameter(np, tag);
  else
    return (otherwise);
}
template <class NamedParameters, class Tag, class T,
          std::enable_if_t<!std::is_lvalue_reference_v<T>, int> = 0>
auto parameter(const NamedParameters& np, Tag tag, T&& otherwise)
{
  return parameter<NamedParameters, Tag, const T>(np, tag, otherwise);
}

// The type of a parameter, or `Default`.
template <class Tag, class NamedParameters, class Default>
using Parameter_type =
  std::decay_t<decltype(parameter(std::declval<const NamedParameters&>(), Tag(), std::declval<Default&>()))>;

// The visitor among the parameters, as a reference.
template <class NamedParameters>
using Visitor_of = decltype(parameter(std::declval<const NamedParameters&>(), CGAL::internal_np::visitor,
                                      std::declval<Default_visitor&>()));

// Whether a parameter is a range, if it is given, whose elements a generic lambda expression takes.
template <class Tag, class NamedParameters, class Function>
constexpr bool is_range_for(Function f)
{
  if constexpr (has_parameter<Tag, NamedParameters>) {
    using Range = std::remove_reference_t<decltype(parameter(std::declval<const NamedParameters&>(), Tag()))>;
    return is_valid<typename Range_element<Range>::type>(f);
  } else {
    return true;
  }
}

// Whether what the function writes to a parameter reaches the caller; else it would be lost with a copy.
template <class Tag, class NamedParameters>
constexpr bool is_writable()
{
  if constexpr (has_parameter<Tag, NamedParameters>)
    return !std::is_const_v<
      std::remove_reference_t<decltype(parameter(std::declval<const NamedParameters&>(), Tag()))>>;
  else
    return true;
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

// For the first line of a function: a parameter that the function does not know is a mistake. `names` is one
// string literal, "energy, effort".
#define CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, names)                                       \
  static_assert(CGAL::Simple_manifolds::internal::are_listed<NamedParameters>(names),                        \
                "this function does not know one of its named parameters; it knows " names)

// The parameter `name` is one to write to.
#define CGAL_SIMPLE_MANIFOLDS_WRITTEN_PARAMETER(NamedParameters, name)                                       \
  static_assert(CGAL::Simple_manifolds::internal::is_writable<CGAL::Simple_manifolds::internal_np::name##_t, \
                                                              NamedParameters>(),                            \
                #name " is written to: pass it by std::ref, a copy would be lost")

// The parameter `name` is a range, and `expression` one of an element `x`.
#define CGAL_SIMPLE_MANIFOLDS_RANGE_PARAMETER(NamedParameters, name, x, expression, elements)                \
  static_assert(                                                                                             \
    CGAL::Simple_manifolds::internal::is_range_for<CGAL::Simple_manifolds::internal_np::name##_t,            \
                                                   NamedParameters>(                                         \
      [](auto&& x) -> decltype(void(expression)) {}),                                                        \
    #name " is no range of " elements)

#endif // CGAL_SIMPLE_MANIFOLDS_INTERNAL_NAMED_PARAMETERS_H
