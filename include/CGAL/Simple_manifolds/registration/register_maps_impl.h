// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/registration/internal/Coarse_to_fine_registration.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_polish.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>

#include <Eigen/Core>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

template <class Atlas>
std::shared_ptr<const Manifold_map<Atlas>>
with_domain_points(const Manifold_map<Atlas>& map, std::vector<typename Atlas::Domain_point> points)
{
  return std::make_shared<const Manifold_map<Atlas>>(
    map.points(), map.faces(), std::move(points), map.number_of_input_vertices(),
    map.number_of_virtual_faces(), map.input_indices(), map.atlas());
}

// Says which landmarks could not be met, all of them up to ten.
[[noreturn]] inline void throw_landmarks_not_met(const std::vector<std::pair<int, int>>& pairs,
                                                 std::size_t all, const std::string& why)
{
  std::string text = std::to_string(pairs.size()) + " of " + std::to_string(all) + " landmarks " + why + ":";
  for (std::size_t i = 0; i < pairs.size() && i < 10; ++i)
    text += (i == 0 ? " vertex " : ", ") + std::to_string(pairs[i].first) + " to " +
            std::to_string(pairs[i].second);
  if (pairs.size() > 10) text += ", ...";
  throw Numeric_error(Error_code::landmarks_not_met, text,
                      Mesh_element::vertex(static_cast<std::size_t>(pairs[0].first)));
}

// Pairs without repetitions; a vertex of either shape has one partner.
inline std::vector<std::pair<int, int>> consistent_pairs(std::vector<std::pair<int, int>> pairs)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::pair<int, int>> bad;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (std::any_of(pairs.begin(), pairs.end(), [&](const auto& other) {
          return other != pairs[i] && (other.first == pairs[i].first || other.second == pairs[i].second);
        }))
      bad.push_back(pairs[i]);
  if (!bad.empty()) throw_landmarks_not_met(bad, pairs.size(), "contradict each other");
  return pairs;
}

// Improves two registered surfaces. What does not make the energy of both less is not kept.
template <class Geometry>
class Registration_improvement {
public:
  Registration_improvement(Registered_surface<Geometry>& source, Registered_surface<Geometry>& target,
                           const Registration_request& request, const Registration_options& options,
                           Registration_report& report)
    : source_(source), target_(target), request_(request), options_(options), report_(report),
      on_source_(source, frozen(&std::pair<int, int>::first), options),
      on_target_(target, frozen(&std::pair<int, int>::second), options)
  {
    report.energies.assign(1, energy());
  }

  // Lays the source out once more, from where it is on the coarse levels: what the finer levels have found is a better
  // start than the search.
  void lay_out_again()
  {
    std::vector<Indexed_landmark<typename Geometry::Point>> landmarks;
    for (const auto& l : request_.landmarks)
      landmarks.push_back({l.first, source_.domain_points[l.first], 1});
    Registration_course course;
    const Lift<Geometry> lift = target_.lift();
    auto points =
      Coarse_to_fine_registration<Geometry>(source_, lift, landmarks, options_, true)
        .run(course, [&](double fraction) { request_.visitor.progress(0.4 * (std::min)(fraction, 1.)); });
    if (!points || !course.unreached.empty()) return;
    std::swap(source_.domain_points, *points);
    if (!is_better()) std::swap(source_.domain_points, *points);
  }

  // Passes of the finest level over the source and the target, by turns.
  void polish()
  {
    const bool is_fast = request_.effort == Effort::FAST;
    const int passes = request_.effort == Effort::QUALITY ? 9 : 5, worst = is_fast ? 0 : 20;
    for (int pass = 0; pass < passes; ++pass) {
      const bool is_source = request_.has_fixed_target || pass % 2 == 0;
      const int sweeps = (pass == 0 ? 20 : 4) / (is_fast ? 2 : 1);
      Registered_surface<Geometry>& moved = is_source ? source_ : target_;
      std::vector<typename Geometry::Point> before = moved.domain_points;
      if (is_source)
        on_source_.run(source_, target_.lift(), sweeps, worst);
      else
        on_target_.run(target_, source_.lift(), sweeps, worst);
      if (!is_better()) moved.domain_points = std::move(before);
      request_.visitor.progress(0.4 + 0.6 * (pass + 1.) / passes);
    }
  }

private:
  std::vector<int> frozen(int std::pair<int, int>::*side) const
  {
    std::vector<int> vertices;
    for (const auto& l : request_.landmarks) vertices.push_back(l.*side);
    return vertices;
  }
  double energy()
  {
    return (on_source_.run(source_, target_.lift(), 0) + on_target_.run(target_, source_.lift(), 0)) / 2;
  }
  bool is_better()
  {
    const double now = energy();
    if (!(now < report_.energies.back())) return false;
    report_.energies.push_back(now);
    return true;
  }

  Registered_surface<Geometry>&source_, &target_;
  const Registration_request& request_;
  const Registration_options& options_;
  Registration_report& report_;
  Registration_polish<Geometry> on_source_, on_target_;
};

template <class Atlas>
Correspondence<Atlas> registered(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                                 const Registration_request& asked, Registration_report& report)
{
  using Geometry = typename Registration_geometry_of<Atlas>::type;
  using Point = typename Atlas::Domain_point;
  Registration_request request = asked;
  request.landmarks = consistent_pairs(std::move(request.landmarks));
  report = Registration_report();
  report.landmarks = request.landmarks.size();
  std::vector<Indexed_landmark<Point>> landmarks;
  for (const auto& l : request.landmarks) landmarks.push_back({l.first, target.domain_point(l.second), 1});

  Registered_surface<Geometry> a(source.points(), source.faces(), source.domain_points());
  Registered_surface<Geometry> b(target.points(), target.faces(), target.domain_points());
  const Lift<Geometry> lift = b.lift();
  Registration_options options;
  options.is_parallel = request.is_parallel;
  options.sweeps = request.effort == Effort::FAST ? 0.5 : request.effort == Effort::QUALITY ? 2 : 1;
  std::string fault; // of the last attempt
  for (int attempt = 0; attempt < number_of_attempts; ++attempt) {
    request.visitor.start_phase("register");
    Registration_course course;
    std::optional<std::vector<Point>> points =
      Coarse_to_fine_registration<Geometry>(a, lift, landmarks, options).run(course, [&](double fraction) {
        request.visitor.progress((std::min)(fraction, 1.));
      });
    request.visitor.end_phase();
    if (points && !course.unreached.empty()) {
      std::vector<std::pair<int, int>> bad;
      for (const int i : course.unreached) bad.push_back(request.landmarks[i]);
      throw_landmarks_not_met(bad, landmarks.size(),
                              "cannot be met with the connectivity of the first shape");
    }
    if (points) {
      Registered_surface<Geometry> c(source.points(), source.faces(), std::move(*points)), d = b;
      report.exact_at = course.exact_at;
      report.rotations = std::move(course.rotations);
      request.visitor.start_phase("polish");
      Registration_improvement<Geometry> improvement(c, d, request, options, report);
      if (request.effort != Effort::FAST) improvement.lay_out_again();
      improvement.polish();
      request.visitor.end_phase();
      request.visitor.start_phase("certify");
      try {
        Correspondence<Atlas> result(with_domain_points(source, std::move(c.domain_points)),
                                     with_domain_points(target, std::move(d.domain_points)));
        request.visitor.end_phase();
        return result;
      } catch (const Numeric_error& e) { // begin anew with a better conditioned energy
        fault = std::string("; the last attempt: ") + e.what();
      }
      request.visitor.end_phase();
    }
    options.area_floor = attempt == 0 ? 0.5 : 1;
    options.shape_floor = attempt == 0 ? 1 : 100;
  }
  throw Numeric_error(Error_code::numeric_failure, "no registration in double precision was found for the " +
                                                     std::to_string(source.number_of_faces()) + " and " +
                                                     std::to_string(target.number_of_faces()) + " faces" +
                                                     fault);
}

template <class Atlas>
std::shared_ptr<const Manifold_map<Atlas>> polished(const std::shared_ptr<const Manifold_map<Atlas>>& map,
                                                    const Manifold_map<Atlas>& target,
                                                    const Registration_request& request)
{
  using Geometry = typename Registration_geometry_of<Atlas>::type;
  Registered_surface<Geometry> a(map->points(), map->faces(), map->domain_points());
  const Registered_surface<Geometry> b(target.points(), target.faces(), target.domain_points());
  const Lift<Geometry> lift = b.lift();
  std::vector<int> frozen;
  for (const auto& l : request.landmarks) frozen.push_back(l.first);
  Registration_options options;
  options.is_parallel = request.is_parallel;
  request.visitor.start_phase("polish");
  Registration_polish<Geometry> polish(a, frozen, options);
  const double before = polish.run(a, lift, 0);
  const double after = polish.run(a, lift, request.effort == Effort::FAST ? 3 : 6);
  request.visitor.end_phase();
  if (!(after < before)) return map;
  try {
    return with_domain_points(*map, std::move(a.domain_points));
  } catch (const Numeric_error&) { // rounding: what could be better is no map
    return map;
  }
}

#ifdef CGAL_SIMPLE_MANIFOLDS_COMPILED
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF(Atlas)                                                         \
  CGAL_SIMPLE_MANIFOLDS_INSTANTIATE std::shared_ptr<const Manifold_map<Atlas>> polished<Atlas>(              \
    const std::shared_ptr<const Manifold_map<Atlas>>&, const Manifold_map<Atlas>&,                           \
    const Registration_request&);                                                                            \
  CGAL_SIMPLE_MANIFOLDS_INSTANTIATE Correspondence<Atlas> registered<Atlas>(                                 \
    const Manifold_map<Atlas>&, const Manifold_map<Atlas>&, const Registration_request&,                     \
    Registration_report&)
CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF(Sphere_atlas);
CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF(Torus_atlas);
CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF(Plane_atlas);
#undef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H
