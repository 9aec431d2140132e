// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_IMPROVEMENT_H
#define CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_IMPROVEMENT_H

#include <CGAL/Simple_manifolds/correspondence/Map_options.h>
#include <CGAL/Simple_manifolds/registration/internal/Coarse_to_fine_registration.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_polish.h>
#include <CGAL/Simple_manifolds/registration/internal/Registration_request.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// Improves two registered surfaces. What does not make the energy of both less is not kept.
template <class Geometry>
class Registration_improvement {
public:
  Registration_improvement(Registered_surface<Geometry>& source, Registered_surface<Geometry>& target,
                           const Registration_request& request, const Registration_options& options)
    : source_(source), target_(target), request_(request), options_(options),
      on_source_(source, frozen(&std::pair<int, int>::first), options),
      on_target_(target, frozen(&std::pair<int, int>::second), options)
  {
  }

  // Begins with the domain points that the surfaces have. is_backwards: the target is moved first.
  void start(bool is_backwards)
  {
    is_backwards_ = is_backwards;
    energies_.assign(1, energy());
  }

  // The mean energy on both surfaces: at the start, and after each step that made it less.
  const std::vector<double>& energies() const { return energies_; }

  // Lays the first surface out once more, from where it is on the coarse levels: what the finer levels have found is a
  // better start than the search.
  template <class Progress>
  void lay_out_again(const Progress& progress)
  {
    Registered_surface<Geometry>&moved = is_backwards_ ? target_ : source_,
    &fixed = is_backwards_ ? source_ : target_;
    std::vector<Indexed_landmark<typename Geometry::Point>> landmarks;
    for (const auto& [first, second] : request_.landmarks) {
      const int v = is_backwards_ ? second : first;
      landmarks.push_back({v, moved.domain_points[v], 1});
    }
    Registration_course course;
    const Lift<Geometry> lift = fixed.lift();
    Coarse_to_fine_registration<Geometry> again(moved, lift, landmarks, options_, true);
    if (!again.begin(1, course, progress)) return;
    auto points = again.finish(0, course, progress);
    if (!points || !course.unreached.empty()) return;
    std::swap(moved.domain_points, *points);
    if (!is_better()) std::swap(moved.domain_points, *points);
  }

  // As far as it has to go to tell starts apart. progress(fraction) is called while it does.
  template <class Progress>
  void try_out(const Progress& progress)
  {
    if (request_.effort != Effort::FAST) lay_out_again([&](double fraction) { progress(0.6 * fraction); });
    double done = 0.6;
    run_pass(0, 4, 20, [&] { progress(done += 0.4 / 6); });
  }

  // Passes of the finest level over the source and the target, by turns. Then more of them where the distortion is large,
  // for as long as that helps.
  void polish()
  {
    const bool is_fast = request_.effort == Effort::FAST;
    const int passes = request_.effort == Effort::QUALITY ? 9 : 5, more = is_fast ? 0 : 8;
    double done = 0;
    const auto progress = [&] { request_.visitor.progress(done); };
    for (int pass = 0; pass < passes; ++pass) {
      run_pass(pass, (pass == 0 ? 20 : 4) / (is_fast ? 2 : 1), is_fast ? 0 : 20, progress);
      done = (pass + 1.) / (passes + more);
    }
    for (int pass = passes; pass + 1 < passes + more; pass += 2) {
      const double before = energies_.back();
      for (const int k : {pass, pass + 1}) run_pass(k, 0, 40, progress);
      if (energies_.back() > 0.97 * before) return;
      done = (pass + 2.) / (passes + more);
    }
  }

private:
  template <class Between>
  void run_pass(int pass, int sweeps, int sweeps_of_worst, const Between& between)
  {
    const bool is_source = request_.has_fixed_target || (pass % 2 == 1) == is_backwards_;
    Registered_surface<Geometry>& moved = is_source ? source_ : target_;
    std::vector<typename Geometry::Point> before = moved.domain_points;
    if (is_source)
      on_source_.run(source_, target_.lift(), sweeps, sweeps_of_worst, between);
    else
      on_target_.run(target_, source_.lift(), sweeps, sweeps_of_worst, between);
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
    return (on_source_.energy(source_, target_.lift()) + on_target_.energy(target_, source_.lift())) / 2;
  }
  bool is_better()
  {
    const double now = energy();
    if (!(now < energies_.back())) return false;
    energies_.push_back(now);
    return true;
  }

  Registered_surface<Geometry>&source_, &target_;
  const Registration_request& request_;
  const Registration_options& options_;
  Registration_polish<Geometry> on_source_, on_target_;
  bool is_backwards_ = false;
  std::vector<double> energies_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_REGISTRATION_INTERNAL_REGISTRATION_IMPROVEMENT_H
