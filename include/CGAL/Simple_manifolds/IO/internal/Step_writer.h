// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_WRITER_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_WRITER_H

#include <CGAL/Simple_manifolds/IO/Step_options.h>
#include <CGAL/Simple_manifolds/IO/internal/Step_file.h>
#include <CGAL/Simple_manifolds/cad/Cad_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

/// Writes a STEP file: each body is a product with one representation.
class Step_writer {
public:
  Step_writer(std::ostream& out, const Step_options& options, const std::string& title)
    : out_(out), options_(options), file_(out)
  {
    const bool is_214 = options.schema == Step_schema::AP214;
    const std::string schema = is_214
                                 ? "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"
                                 : "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }";
    // The time is not that of writing: the same surface is the same file.
    out_ << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" << step_text(title) << "),'2;1');\nFILE_NAME("
         << step_text(title)
         << ",'1970-01-01T00:00:00',(''),(''),'Simple_manifolds','Simple_manifolds','');\nFILE_SCHEMA(('"
         << schema << "'));\nENDSEC;\nDATA;\n";
    application_ =
      file_.add("APPLICATION_CONTEXT", is_214 ? "core data for automotive mechanical design processes"
                                              : "managed model based 3d engineering");
    file_.add("APPLICATION_PROTOCOL_DEFINITION", "international standard",
              is_214 ? "automotive_design" : "ap242_managed_model_based_3d_engineering", is_214 ? 2000 : 2014,
              application_);
    product_context_ = file_.add("PRODUCT_CONTEXT", "", application_, "mechanical");
    definition_context_ = file_.add("PRODUCT_DEFINITION_CONTEXT", "part definition", application_, "design");
    length_ = length_unit();
    angle_ = file_.add_text("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    solid_angle_ = file_.add_text("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    plane_ = file_.add_text("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()"
                            "REPRESENTATION_CONTEXT('','2D'))");
    const Step_id origin = point(Eigen::Vector3d::Zero());
    const Step_id z = file_.add("DIRECTION", "", std::vector<double>{0, 0, 1});
    const Step_id x = file_.add("DIRECTION", "", std::vector<double>{1, 0, 0});
    axes_ = file_.add("AXIS2_PLACEMENT_3D", "", origin, z, x);
  }

  void body(const Cad_surface& surface, const std::string& name, const Eigen::Vector3d& colour)
  {
    points_.clear();
    const Step_id product = file_.add("PRODUCT", name, name, "", std::vector<Step_id>{product_context_});
    file_.add("PRODUCT_RELATED_PRODUCT_CATEGORY", "part", Step_token{"$"}, std::vector<Step_id>{product});
    const Step_id formation = file_.add("PRODUCT_DEFINITION_FORMATION", "", "", product);
    const Step_id definition = file_.add("PRODUCT_DEFINITION", "design", "", formation, definition_context_);
    const Step_id shape = file_.add("PRODUCT_DEFINITION_SHAPE", "", "", definition);
    const Step_id context = space(surface.diagonal() * options_.scale);

    const Step_id shell = file_.add(surface.is_closed() ? "CLOSED_SHELL" : "OPEN_SHELL", "", faces(surface));
    const Step_id item = surface.is_closed()
                           ? file_.add("MANIFOLD_SOLID_BREP", name, shell)
                           : file_.add("SHELL_BASED_SURFACE_MODEL", name, std::vector<Step_id>{shell});
    const Step_id representation = file_.add(surface.is_closed() ? "ADVANCED_BREP_SHAPE_REPRESENTATION"
                                                                 : "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
                                             name, std::vector<Step_id>{axes_, item}, context);
    file_.add("SHAPE_DEFINITION_REPRESENTATION", shape, representation);
    style(item, colour, context);
  }

  void end() { out_ << "ENDSEC;\nEND-ISO-10303-21;\n"; }

private:
  using Key = std::array<double, 3>;

  Step_id length_unit()
  {
    if (options_.unit == Step_unit::INCH) {
      const Step_id mm = file_.add_text("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
      const Step_id exponents = file_.add("DIMENSIONAL_EXPONENTS", 1., 0., 0., 0., 0., 0., 0.);
      const Step_id measure = file_.add("LENGTH_MEASURE_WITH_UNIT", Step_token{"LENGTH_MEASURE(25.4)"}, mm);
      return file_.add_text("(CONVERSION_BASED_UNIT('INCH'," + step_text(measure) +
                            ")LENGTH_UNIT()NAMED_UNIT(" + step_text(exponents) + "))");
    }
    const char* prefix = options_.unit == Step_unit::METRE        ? "$"
                         : options_.unit == Step_unit::CENTIMETRE ? ".CENTI."
                                                                  : ".MILLI.";
    return file_.add_text(std::string("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(") + prefix + ",.METRE.))");
  }

  // The space of a body of some size, with the distance below which points are the same.
  Step_id space(double diagonal)
  {
    const Step_id uncertainty =
      file_.add("UNCERTAINTY_MEASURE_WITH_UNIT",
                Step_token{"LENGTH_MEASURE(" + step_text((std::max)(1e-7, 1e-8 * diagonal)) + ")"}, length_,
                "distance_accuracy_value", "confusion accuracy");
    return file_.add_text("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(" +
                          step_text(std::vector<Step_id>{uncertainty}) + ")GLOBAL_UNIT_ASSIGNED_CONTEXT(" +
                          step_text(std::vector<Step_id>{length_, angle_, solid_angle_}) +
                          ")REPRESENTATION_CONTEXT('','3D'))");
  }

  Step_id point(const Eigen::Vector3d& x)
  {
    return file_.add("CARTESIAN_POINT", "", Eigen::Vector3d(options_.scale * x));
  }

  // Equal points of borders are one entity, so that neighbours share them.
  Step_id shared_point(const Eigen::Vector3d& x)
  {
    Step_id& id = points_[{x[0], x[1], x[2]}];
    if (id.number == 0) id = point(x);
    return id;
  }

  // Knots with their multiplicities.
  struct Knots {
    std::vector<int> multiplicities;
    std::vector<double> values;

    explicit Knots(const std::vector<double>& knots)
    {
      for (const double k : knots) {
        if (values.empty() || values.back() != k) {
          values.push_back(k);
          multiplicities.push_back(0);
        }
        ++multiplicities.back();
      }
    }
  };

  Step_id face_surface(const Cad_face& face)
  {
    const int n = face.controls_u(), m = face.controls_v();
    std::vector<std::vector<Step_id>> controls(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        const Eigen::Vector3d& x = face.controls[i * m + j];
        const bool is_border = i == 0 || j == 0 || i == n - 1 || j == m - 1;
        controls[i].push_back(is_border ? shared_point(x) : point(x));
      }
    const Knots u(face.knots_u), v(face.knots_v);
    const Step_token no{".F."}, unspecified{".UNSPECIFIED."};
    return file_.add("B_SPLINE_SURFACE_WITH_KNOTS", "", face.degree, face.degree, controls, unspecified, no,
                     no, no, u.multiplicities, v.multiplicities, u.values, v.values, unspecified);
  }

  Step_id edge_curve(const Cad_curve& curve)
  {
    std::vector<Step_id> controls;
    for (const Eigen::Vector3d& x : curve.controls) controls.push_back(shared_point(x));
    const Knots knots(curve.knots);
    const Step_token no{".F."}, unspecified{".UNSPECIFIED."};
    return file_.add("B_SPLINE_CURVE_WITH_KNOTS", "", curve.degree, controls, unspecified, no, no,
                     knots.multiplicities, knots.values, unspecified);
  }

  // The line of an edge in the parameters of a face, with the parameter of the edge.
  Step_id parameter_curve(const Cad_face::Use& use, Step_id on)
  {
    const std::vector<double> at =
      use.is_along_u ? std::vector<double>{0, use.at} : std::vector<double>{use.at, 0};
    const std::vector<double> along = use.is_along_u ? std::vector<double>{1, 0} : std::vector<double>{0, 1};
    const Step_id start = file_.add("CARTESIAN_POINT", "", at), direction = file_.add("DIRECTION", "", along);
    const Step_id vector = file_.add("VECTOR", "", direction, 1.),
                  line = file_.add("LINE", "", start, vector);
    const Step_id curve = file_.add("DEFINITIONAL_REPRESENTATION", "", std::vector<Step_id>{line}, plane_);
    return file_.add("PCURVE", "", on, curve);
  }

  std::vector<Step_id> faces(const Cad_surface& surface)
  {
    std::vector<Step_id> surfaces, vertices, edges, list;
    for (const Cad_face& face : surface.faces()) surfaces.push_back(face_surface(face));
    for (const Eigen::Vector3d& x : surface.vertices())
      vertices.push_back(file_.add("VERTEX_POINT", "", shared_point(x)));
    std::vector<std::vector<Step_id>> parameter_curves(surface.edges().size());
    std::vector<std::vector<std::size_t>> faces_of(surface.edges().size());
    for (std::size_t f = 0; f < surface.faces().size(); ++f)
      for (const Cad_face::Use& use : surface.faces()[f].border) {
        parameter_curves[use.edge].push_back(parameter_curve(use, surfaces[f]));
        faces_of[use.edge].push_back(f);
      }
    for (std::size_t k = 0; k < surface.edges().size(); ++k) {
      const Cad_surface::Edge& edge = surface.edges()[k];
      const bool is_seam = faces_of[k].size() == 2 && faces_of[k][0] == faces_of[k][1];
      const Step_id curve = file_.add(is_seam ? "SEAM_CURVE" : "SURFACE_CURVE", "", edge_curve(edge.curve),
                                      parameter_curves[k], Step_token{".PCURVE_S1."});
      edges.push_back(file_.add("EDGE_CURVE", "", vertices[edge.vertices.first],
                                vertices[edge.vertices.second], curve, Step_token{".T."}));
    }
    for (std::size_t f = 0; f < surface.faces().size(); ++f) {
      std::vector<Step_id> border;
      for (const Cad_face::Use& use : surface.faces()[f].border)
        border.push_back(file_.add("ORIENTED_EDGE", "", Step_token{"*"}, Step_token{"*"}, edges[use.edge],
                                   Step_token{use.is_forward ? ".T." : ".F."}));
      const Step_id loop = file_.add("EDGE_LOOP", "", border);
      const Step_id bound = file_.add("FACE_OUTER_BOUND", "", loop, Step_token{".T."});
      list.push_back(file_.add("ADVANCED_FACE", "face " + std::to_string(f + 1), std::vector<Step_id>{bound},
                               surfaces[f], Step_token{".T."}));
    }
    return list;
  }

  void style(Step_id item, const Eigen::Vector3d& colour, Step_id context)
  {
    const auto list = [](Step_id id) { return std::vector<Step_id>{id}; };
    const Step_id rgb = file_.add("COLOUR_RGB", "", colour[0], colour[1], colour[2]);
    const Step_id fill_colour = file_.add("FILL_AREA_STYLE_COLOUR", "", rgb);
    const Step_id fill = file_.add("FILL_AREA_STYLE", "", list(fill_colour));
    const Step_id area = file_.add("SURFACE_STYLE_FILL_AREA", fill);
    const Step_id side = file_.add("SURFACE_SIDE_STYLE", "", list(area));
    const Step_id usage = file_.add("SURFACE_STYLE_USAGE", Step_token{".BOTH."}, side);
    const Step_id assignment = file_.add("PRESENTATION_STYLE_ASSIGNMENT", list(usage));
    const Step_id styled = file_.add("STYLED_ITEM", "", list(assignment), item);
    file_.add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION", "", list(styled), context);
  }

  std::ostream& out_;
  const Step_options& options_;
  Step_file file_;
  Step_id application_, product_context_, definition_context_, length_, angle_, solid_angle_, plane_, axes_;
  std::map<Key, Step_id> points_;
};

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_STEP_WRITER_H
