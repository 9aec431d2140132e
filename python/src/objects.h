// What Python holds: maps and surfaces over whichever canonical surface.

#ifndef SIMPLE_MANIFOLDS_PYTHON_OBJECTS_H
#define SIMPLE_MANIFOLDS_PYTHON_OBJECTS_H

#include "calls.h"

#include <CGAL/Simple_manifolds/Input_indices.h>
#include <CGAL/Simple_manifolds/correspondence/Any_map.h>
#include <CGAL/Simple_manifolds/correspondence/Manifold_map.h>
#include <CGAL/Simple_manifolds/embedding/Fit_report.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>

#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace simple_manifolds_python {

// Rows of domain points that a map or a surface is asked at.
template <class Atlas>
using Domain_rows = Rows<typename Atlas::Domain_point>;

template <class Atlas>
void require_domain_points(const Domain_rows<Atlas>& rows, const Atlas& atlas)
{
  require_finite(rows.data(), rows.size() * Row<typename Atlas::Domain_point>::columns, "domain_points");
  if constexpr (std::is_same_v<Atlas, SM::Sphere_atlas>) {
    for (const auto& p : rows)
      if (p.isZero(0)) wrong("domain_points: the zero vector has no direction");
  } else if constexpr (std::is_same_v<Atlas, SM::Hyperbolic_atlas>) {
    for (const auto& p : rows)
      if (!atlas.is_valid(p))
        wrong("domain_points: (tile, u, v) with a tile of the surface and |u|, |v| <= 1 is expected");
  }
  (void)atlas;
}

// The same as points of the domain itself: unit vectors, coordinates in [0,1). In place where they are.
template <class Atlas>
class Domain_points {
public:
  using Point = typename Atlas::Domain_point;

  Domain_points(const Doubles& array, const Atlas& atlas) : rows_(array, "domain_points")
  {
    require_domain_points(rows_, atlas);
    if (std::all_of(rows_.begin(), rows_.end(), [&](const Point& p) { return atlas.is_valid(p); })) return;
    copy_.reserve(rows_.size());
    for (const Point& p : rows_) copy_.push_back(atlas.query(p));
  }

  const Point* begin() const { return copy_.empty() ? rows_.begin() : copy_.data(); }
  std::size_t size() const { return rows_.size(); }

private:
  Domain_rows<Atlas> rows_;
  std::vector<Point> copy_;
};

// A map of any kind, shared with correspondences.
class Map {
public:
  template <class Atlas>
  using Shared = std::shared_ptr<const SM::Manifold_map<Atlas>>;
  using Variant = SM::Canonical_surfaces::Variant<Shared>;

  explicit Map(Variant map) : map_(std::move(map)) {}
  // outer: what the arrays from which it was made are in the caller's input.
  Map(SM::Any_map map, const SM::Input_indices& outer)
    : map_(std::visit(
        [](auto& m) -> Variant { return std::make_shared<const std::decay_t<decltype(m)>>(std::move(m)); },
        map)),
      outer_(outer)
  {
  }

  // f(map) with a Manifold_map.
  template <class F>
  auto visit(const F& f) const
  {
    return std::visit([&](const auto& map) { return f(*map); }, map_);
  }
  const Variant& variant() const { return map_; }
  const SM::Input_indices& outer() const { return outer_; }

private:
  Variant map_;
  SM::Input_indices outer_;
};

// A surface of any kind, with what is known of its fit.
class Surface {
public:
  Surface(SM::Any_surface<> surface, double tolerance, std::optional<SM::Fit_report> report = std::nullopt,
          std::optional<Map> map = std::nullopt)
    : surface_(std::make_shared<const SM::Any_surface<>>(std::move(surface))), tolerance_(tolerance),
      report_(std::move(report)), map_(std::move(map))
  {
  }

  template <class F>
  auto visit(const F& f) const
  {
    return std::visit([&](const auto& surface) { return f(surface); }, *surface_);
  }
  double tolerance() const { return tolerance_; } // 0: unknown
  const std::optional<SM::Fit_report>& report() const { return report_; }
  const std::optional<Map>& map() const { return map_; } // that it suits

  // What closest_points() has made to search with; belongs to it.
  mutable std::shared_ptr<const void> finder;

private:
  std::shared_ptr<const SM::Any_surface<>> surface_;
  double tolerance_;
  std::optional<SM::Fit_report> report_;
  std::optional<Map> map_;
};

// The Python exception of an error whose class got lost, as in the results for several components.
py::object exception_of(const SM::Error& e);

} // namespace simple_manifolds_python

#endif // SIMPLE_MANIFOLDS_PYTHON_OBJECTS_H
