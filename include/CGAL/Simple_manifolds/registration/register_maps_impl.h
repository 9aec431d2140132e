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
    Coarse_to_fine_registration<Geometry> again(source_, lift, landmarks, options_, true);
    const auto progress = [&](double fraction) { request_.visitor.progress(0.4 * (std::min)(fraction, 1.)); };
    if (!again.begin(course, progress)) return;
    auto points = again.finish(course, progress);
    if (!points || !course.unreached.empty()) return;
    std::swap(source_.domain_points, *points);
    if (!is_better()) std::swap(source_.domain_points, *points);
  }

  // Passes of the finest level over the source and the target, by turns. Then more of them where the distortion is large,
  // for as long as that helps.
  void polish()
  {
    const bool is_fast = request_.effort == Effort::FAST;
    const int passes = request_.effort == Effort::QUALITY ? 9 : 5, more = is_fast ? 0 : 8;
    for (int pass = 0; pass < passes; ++pass) {
      run_pass(pass, (pass == 0 ? 20 : 4) / (is_fast ? 2 : 1), is_fast ? 0 : 20);
      request_.visitor.progress(0.4 + 0.6 * (pass + 1.) / (passes + more));
    }
    for (int pass = passes; pass + 1 < passes + more; pass += 2) {
      const double before = report_.energies.back();
      for (const int k : {pass, pass + 1}) run_pass(k, 0, 40);
      if (report_.energies.back() > 0.97 * before) return;
      request_.visitor.progress(0.4 + 0.6 * (pass + 2.) / (passes + more));
    }
  }

private:
  void run_pass(int pass, int sweeps, int sweeps_of_worst)
  {
    const bool is_source = request_.has_fixed_target || pass % 2 == 0;
    Registered_surface<Geometry>& moved = is_source ? source_ : target_;
    std::vector<typename Geometry::Point> before = moved.domain_points;
    if (is_source)
      on_source_.run(source_, target_.lift(), sweeps, sweeps_of_worst);
    else
      on_target_.run(target_, source_.lift(), sweeps, sweeps_of_worst);
    if (!is_better()) moved.domain_points = std::move(before);
  }

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

// One of two surfaces laid out coarse to fine against the other one.
template <class Geometry>
struct One_way {
  using Landmarks = std::vector<Indexed_landmark<typename Geometry::Point>>;

  One_way(const Registered_surface<Geometry>& moved, const Registered_surface<Geometry>& fixed, bool is_back,
          const Landmarks& landmarks, const Registration_options& options)
    : is_backwards(is_back), lift(fixed.lift()), layout(moved, lift, landmarks, options)
  {
  }

  bool is_backwards; // the target is moved
  bool is_finished = false;
  Lift<Geometry> lift;
  Coarse_to_fine_registration<Geometry> layout;
  Registration_course course;
  std::optional<std::vector<typename Geometry::Point>> points; // the result
};

// Lays out the source against the target, or the other way where that promises less distortion: moved faces of one can be
// too coarse for a limb of the other one, and seldom both. No points: doubles do not suffice.
template <class Geometry>
std::unique_ptr<One_way<Geometry>>
better_way(const Registered_surface<Geometry>& a, const Registered_surface<Geometry>& b,
           const Registration_request& request, const Registration_options& options)
{
  using Way = One_way<Geometry>;
  constexpr double doubtful = 0.3; // mean logarithm of the distortion
  double done = 0;                 // the second way starts from nothing again
  const auto progress = [&](double fraction) {
    done = (std::max)(done, (std::min)(fraction, 1.));
    request.visitor.progress(done);
  };
  const auto begun = [&](bool is_back) {
    using Domain = Registration_domain<Geometry>;
    typename Way::Landmarks landmarks;
    for (const auto& [first, second] : request.landmarks)
      landmarks.push_back({is_back ? second : first,
                           Domain::on_grid(is_back ? a.domain_points[first] : b.domain_points[second]), 1});
    auto way = std::make_unique<Way>(is_back ? b : a, is_back ? a : b, is_back, landmarks, options);
    if (!way->layout.begin(way->course, progress)) way.reset();
    return way;
  };
  const auto finish = [&](Way& way) {
    way.is_finished = true;
    way.points = way.layout.finish(way.course, progress);
    return way.points && way.course.unreached.empty();
  };
  std::unique_ptr<Way> forward = begun(false), back;
  const double energy = forward ? forward->layout.coarse_energy() : std::numeric_limits<double>::infinity();
  if (!request.has_fixed_target && !(energy <= doubtful)) {
    back = begun(true);
    if (back && back->layout.coarse_energy() < energy && finish(*back)) return back;
  }
  if (forward && finish(*forward)) return forward;
  if (back && !back->is_finished && finish(*back)) return back;
  return forward;
}

template <class Atlas>
Correspondence<Atlas> registered(const Manifold_map<Atlas>& source, const Manifold_map<Atlas>& target,
                                 const Registration_request& asked, Registration_report& report)
{
  using Geometry = typename Registration_geometry_of<Atlas>::type;
  Registration_request request = asked;
  request.landmarks = consistent_pairs(std::move(request.landmarks));
  report = Registration_report();
  report.landmarks = request.landmarks.size();
  const Registered_surface<Geometry> a(source.points(), source.faces(), source.domain_points());
  const Registered_surface<Geometry> b(target.points(), target.faces(), target.domain_points());
  Registration_options options;
  options.is_parallel = request.is_parallel;
  options.sweeps = request.effort == Effort::FAST ? 0.5 : request.effort == Effort::QUALITY ? 2 : 1;
  std::string fault; // of the last attempt
  for (int attempt = 0; attempt < number_of_attempts; ++attempt) {
    request.visitor.start_phase("register");
    const std::unique_ptr<One_way<Geometry>> way = better_way(a, b, request, options);
    request.visitor.end_phase();
    if (way && way->points && !way->course.unreached.empty()) {
      std::vector<std::pair<int, int>> bad;
      for (const int i : way->course.unreached) bad.push_back(request.landmarks[i]);
      throw_landmarks_not_met(bad, request.landmarks.size(),
                              "cannot be met with the connectivity of the first shape");
    }
    if (way && way->points) {
      Registered_surface<Geometry> moved = way->is_backwards ? b : a, other = way->is_backwards ? a : b;
      moved.domain_points = std::move(*way->points);
      report.exact_at = way->course.exact_at;
      report.rotations = std::move(way->course.rotations);
      request.visitor.start_phase("polish");
      Registration_request of_way = request;
      if (way->is_backwards)
        for (auto& l : of_way.landmarks) std::swap(l.first, l.second);
      Registration_improvement<Geometry> improvement(moved, other, of_way, options, report);
      if (request.effort != Effort::FAST) improvement.lay_out_again();
      improvement.polish();
      request.visitor.end_phase();
      request.visitor.start_phase("certify");
      try {
        for (const auto& [first, second] : of_way.landmarks) // their last bits, too
          moved.domain_points[first] = other.domain_points[second];
        if (way->is_backwards) std::swap(moved.domain_points, other.domain_points);
        Correspondence<Atlas> result(with_domain_points(source, std::move(moved.domain_points)),
                                     with_domain_points(target, std::move(other.domain_points)));
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
    Registration_report&);
CGAL_SIMPLE_MANIFOLDS_FOR_EACH_REGISTERED_ATLAS(CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF)
#undef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_OF
#endif

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_REGISTER_MAPS_IMPL_H
