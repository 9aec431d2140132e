// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H
#define CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H

#include <CGAL/Simple_manifolds/IO/internal/report/Report_arrays.h>
#include <CGAL/Simple_manifolds/IO/internal/report/Report_part.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>
#include <CGAL/Simple_manifolds/cad/cad_domain_point.h>
#include <CGAL/Simple_manifolds/correspondence/Component.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/internal/map_on_arrays.h>

#include <CGAL/assertions.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// A report of components: add(part, map, k, arrays, prefix) adds to the part of the k-th map what is shown beside it, and
// returns why nothing is.
template <class AnyMap, class Add>
void write_report_of_parts(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                           nlohmann::ordered_json figures, std::string_view page, const Add& add)
{
  const nlohmann::ordered_json of_parts = figures.value("parts", nlohmann::ordered_json::array());
  figures.erase("parts");
  double faces = 0;
  for (const Component<AnyMap>& map : maps)
    if (map.has_value())
      faces +=
        std::visit([](const auto& m) { return static_cast<double>(m.number_of_faces()); }, map.value());
  Report_arrays arrays;
  nlohmann::ordered_json info = {{"figures", std::move(figures)}, {"parts", nlohmann::ordered_json::array()}};
  for (std::size_t k = 0; k < maps.size(); ++k) {
    nlohmann::ordered_json about = {{"name", maps[k].name}};
    if (maps[k].has_value())
      std::visit(
        [&](const auto& any) {
          const auto& map = map_on_arrays(any);
          const std::string prefix = std::to_string(k) + '.';
          Report_part<std::decay_t<decltype(map)>> part(
            map, k < of_parts.size() ? of_parts[k] : nlohmann::ordered_json::object(),
            static_cast<double>(map.number_of_faces()) / faces);
          const std::string error = add(part, map, k, arrays, prefix);
          about.update(part.add_mesh(arrays, prefix));
          if (!error.empty()) about["error"] = error;
        },
        maps[k].value());
    else
      about["error"] = maps[k].error().what();
    info["parts"].push_back(std::move(about));
  }
  write_report_page(file, page, std::move(info), arrays);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a page that shows a map in a browser: the mesh beside its canonical surface, coloured by chart, by
/// chart coordinates or by distortion, and the figures as a table. The page is one file that needs nothing
/// else, neither other files nor a network. Of meshes with more than 100,000 faces it shows a simplification.
///
/// \param figures  what the page lists as a table: groups of named values, as in `metrics.json` of `fit_mesh`
/// \param page  the page without its data: `simple_manifolds_report_page`, in the header
///   `simple_manifolds_report_page.h` that the CMake target `CGAL::Simple_manifolds_report` provides
/// \throw IO_error (`cannot_write`); a file that was there before is then as it was
template <class Map>
void write_report(const std::string& file, const Map& map, const nlohmann::ordered_json& figures,
                  std::string_view page)
{
  internal::Report_arrays arrays;
  auto info = internal::Report_part<internal::Map_on_arrays<Map>>(map, figures).add_mesh(arrays);
  internal::write_report_page(file, page, std::move(info), arrays);
}

// Forward: the functions without a CAD surface call those with one.
template <class Map, class Surface>
void write_report(const std::string& file, const Map& map, const Surface& surface, const Fit_report& report,
                  const Cad_surface* cad, const nlohmann::ordered_json& figures, std::string_view page);
template <class AnyMap, class AnySurface>
void write_report(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                  const std::vector<Component<AnySurface>>& surfaces, const std::vector<Fit_report>& reports,
                  const std::vector<const Cad_surface*>& cad, const nlohmann::ordered_json& figures,
                  std::string_view page);

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with a surface that was fitted to the map: a third panel shows it, and the fit error, its
/// curvatures and its control nets can be shown. Where the error is largest and where the surface turns over
/// is marked in all panels. The triangles that are drawn are not farther from the surface than half the tolerance
/// of the root mean square, unless these would be more than 100,000; the page says how far they are.
/// \param report  of the fit
template <class Map, class Surface>
void write_report(const std::string& file, const Map& map, const Surface& surface, const Fit_report& report,
                  const nlohmann::ordered_json& figures, std::string_view page)
{
  write_report(file, map, surface, report, static_cast<const Cad_surface*>(nullptr), figures, page);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with the faces of a CAD surface over the same atlas, in a panel of their own with their borders.
/// \param cad  null: there is none
template <class Map, class Surface>
void write_report(const std::string& file, const Map& map, const Surface& surface, const Fit_report& report,
                  const Cad_surface* cad, const nlohmann::ordered_json& figures, std::string_view page)
{
  internal::Report_arrays arrays;
  internal::Report_part<internal::Map_on_arrays<Map>> part(map, figures);
  part.add_surface(surface, report, arrays);
  CGAL_precondition(!cad || has_cad_surface<typename Map::Atlas>);
  if constexpr (has_cad_surface<typename Map::Atlas>)
    if (cad) part.add_cad(*cad, arrays);
  auto info = part.add_mesh(arrays);
  internal::write_report_page(file, page, std::move(info), arrays);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same for the maps of components: the page shows those together that are chosen from a list, and the canonical
/// surface, the plots and the figures of one of them. The 100,000 faces are divided among them. A component without a
/// map is in the list with its error.
///
/// \param figures  of all; under `parts` an array with those of each component, in their order
/// \tparam AnyMap  an `Any_map` or `Any_mesh_map`
template <class AnyMap>
void write_report(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                  const nlohmann::ordered_json& figures, std::string_view page)
{
  internal::write_report_of_parts(file, maps, figures, page, [](const auto&...) { return std::string(); });
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with the surfaces that were fitted to the maps. Of a component without a surface the map is shown, if
/// there is one, and the list has its error.
/// \param surfaces,reports  as `fit_components()` gives them
/// \pre `surfaces.size() == maps.size() && reports.size() == maps.size()`; where there is a surface there is a map over
///   the same atlas
/// \tparam AnySurface  an `Any_surface`
template <class AnyMap, class AnySurface>
void write_report(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                  const std::vector<Component<AnySurface>>& surfaces, const std::vector<Fit_report>& reports,
                  const nlohmann::ordered_json& figures, std::string_view page)
{
  write_report(file, maps, surfaces, reports, std::vector<const Cad_surface*>(maps.size()), figures, page);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// The same with the faces of CAD surfaces.
/// \param cad  one for each map, or null
/// \pre `cad.size() == maps.size()`
template <class AnyMap, class AnySurface>
void write_report(const std::string& file, const std::vector<Component<AnyMap>>& maps,
                  const std::vector<Component<AnySurface>>& surfaces, const std::vector<Fit_report>& reports,
                  const std::vector<const Cad_surface*>& cad, const nlohmann::ordered_json& figures,
                  std::string_view page)
{
  CGAL_precondition(surfaces.size() == maps.size() && reports.size() == maps.size() &&
                    cad.size() == maps.size());
  const auto add = [&](auto& part, const auto& map, std::size_t k, auto& arrays, const std::string& prefix) {
    if (cad[k]) part.add_cad(*cad[k], arrays, prefix);
    if (!surfaces[k].has_value()) return std::string(surfaces[k].error().what());
    std::visit(
      [&](const auto& surface) {
        using Surface = std::decay_t<decltype(surface)>;
        constexpr bool is_its_map =
          std::is_same_v<typename std::decay_t<decltype(map)>::Atlas, typename Surface::Atlas>;
        CGAL_precondition_msg(is_its_map, "the map is not the one of the surface");
        if constexpr (is_its_map) part.add_surface(surface, reports[k], arrays, prefix);
      },
      surfaces[k].value());
    return std::string();
  };
  internal::write_report_of_parts(file, maps, figures, page, add);
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_WRITE_REPORT_H
