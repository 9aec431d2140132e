// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/internal/Visitor_reference.h>
#include <CGAL/Simple_manifolds/internal/compiled.h>
#include <CGAL/Simple_manifolds/registration/correspondence_distortion.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_contest.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_polish.h>
#include <CGAL/Simple_manifolds/registration/register_maps.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
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

// The two surfaces as they lie, certified. The domain points of the partners of landmarks are taken bit for bit.
template <class Atlas>
Correspondence<Atlas> certified(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                                std::vector<typename Atlas::Domain_point> source_points,
                                std::vector<typename Atlas::Domain_point> target_points,
                                const std::vector<std::pair<int, int>>& landmarks, bool is_backwards)
{
  for (const auto& [first, second] : landmarks)
    if (is_backwards)
      target_points[second] = source_points[first];
    else
      source_points[first] = target_points[second];
  return Correspondence<Atlas>(with_domain_points(source, std::move(source_points)),
                               with_domain_points(target, std::move(target_points)));
}

// A composition of the given maps, and its distortion.
template <class Atlas>
struct Given_correspondence {
  Correspondence<Atlas> maps;
  Correspondence_distortion distortion;
};

// That of the given maps, the source as it is or moved on the domain to `aligned`, whichever has less distortion; nothing
// where landmarks are not met.
template <class Atlas>
std::optional<Given_correspondence<Atlas>>
best_composition(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                 const std::vector<typename Atlas::Domain_point>& aligned,
                 const std::vector<std::pair<int, int>>& landmarks)
{
  std::optional<Given_correspondence<Atlas>> best;
  const auto shared_target = std::make_shared<const Manifold_map<Atlas>>(target);
  const auto add = [&](const std::vector<typename Atlas::Domain_point>& points) {
    for (const auto& [first, second] : landmarks)
      if (points[first] != target.domain_point(second)) return;
    try {
      const Correspondence<Atlas> c(with_domain_points(source, points), shared_target);
      const Correspondence_distortion d = distortion(c);
      if (!best || d.symmetric() < best->distortion.symmetric()) best = Given_correspondence<Atlas>{c, d};
    } catch (const Numeric_error&) { // not one to one after rounding
    }
  };
  add(source.domain_points());
  if (aligned != source.domain_points()) add(aligned);
  return best;
}

// Whether the distortion is nowhere more: in the means on both shapes, the median and the 95th percentile.
inline bool is_nowhere_worse(const Correspondence_distortion& d, const Correspondence_distortion& other)
{
  return d.mean <= other.mean && d.mean_on_target <= other.mean_on_target && d.median <= other.median &&
         d.p95 <= other.p95 && d.not_positive <= other.not_positive;
}

template <class Atlas>
Correspondence<Atlas> registered(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                                 const Registration_request& asked, Registration_report& report)
{
  using Geometry = typename Registration_geometry_of<Atlas>::type;
  Registration_request request = asked;
  request.landmarks = consistent_pairs(std::move(request.landmarks));
  const Registered_surface<Geometry> a(source.points(), source.faces(), source.domain_points());
  const Registered_surface<Geometry> b(target.points(), target.faces(), target.domain_points());
  Registration_options options;
  options.is_parallel = request.is_parallel;
  options.sweeps = request.effort == Effort::FAST ? 0.5 : request.effort == Effort::QUALITY ? 2 : 1;
  std::string fault; // of the last attempt
  for (int attempt = 0; attempt < number_of_attempts; ++attempt) {
    report = Registration_report();
    report.landmarks = request.landmarks.size();
    Registration_contest<Geometry> contest(a, b, request, options);
    in_phase(request.visitor, "register", [&] { contest.run(); });
    const auto given = best_composition(source, target, contest.aligned_points(), request.landmarks);
    if (!contest.best() && !contest.unreached().empty() && !given) {
      std::vector<std::pair<int, int>> bad;
      for (const int i : contest.unreached()) bad.push_back(request.landmarks[i]);
      throw_landmarks_not_met(bad, request.landmarks.size(),
                              "cannot be met with the connectivity of the first shape");
    }
    // What the contest has improved, if it is good enough.
    const auto result = [&](bool is_backwards) {
      report.energies = contest.energies();
      std::optional<Correspondence<Atlas>> c;
      in_phase(request.visitor, "certify", [&] {
        c = certified(source, target, contest.improved_source().domain_points,
                      contest.improved_target().domain_points, request.landmarks, is_backwards);
        if (given && !is_nowhere_worse(distortion(*c), given->distortion)) c.reset();
      });
      return c;
    };
    bool has_failed = false; // begin anew with a better conditioned energy
    if (contest.best()) {
      report.exact_at = contest.best()->exact_at;
      report.rotations = contest.best()->rotations;
      report.is_backwards = contest.best()->is_backwards;
      try {
        in_phase(request.visitor, "polish", [&] { contest.improve(); });
        if (auto c = result(report.is_backwards)) return std::move(*c);
      } catch (const Numeric_error& e) {
        fault = std::string("; the last attempt: ") + e.what();
        has_failed = true;
      }
    }
    if (given && (!has_failed || attempt + 1 == number_of_attempts)) {
      report.exact_at = 0;
      report.is_backwards = false;
      try {
        report.kept = Kept_registration::GIVEN_MAPS_IMPROVED;
        in_phase(request.visitor, "polish", [&] { contest.improve(given->maps.source().domain_points()); });
        if (contest.energies().size() > 1)
          if (auto c = result(false)) return std::move(*c);
      } catch (const Numeric_error&) { // what could be better is no map
      }
      report.kept = Kept_registration::GIVEN_MAPS;
      report.energies.assign(1, contest.energies().front());
      return given->maps;
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
  const double before = polish.energy(a, lift);
  const int sweeps = request.effort == Effort::FAST ? 3 : 6;
  int done = 0;
  const double after =
    polish.run(a, lift, sweeps, 0, [&] { request.visitor.progress(++done / double(sweeps)); });
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
    Registration_report&);
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_REGISTERED_ATLAS(CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF)
#undef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H
