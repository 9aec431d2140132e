/// \ingroup PkgSimpleManifoldsConcepts
/// \cgalConcept
///
/// The concept `TessellationSizing` says which faces of an adaptive tessellation are too large. A criterion
/// measures a face and compares the result with what it allows: the *excess* of a face is the quotient of the
/// two, and a face with an excess above 1 is split. An excess that is not a number counts as infinite.
///
/// The excess of a face may depend only on where the face is, not on the other faces: faces that stay are not
/// measured again. It should become smaller when the face is split.
///
/// A model has *one* of the two operators. The first is the faster one where a surface has to be evaluated,
/// since ranges of points are evaluated much faster than single points. The second is that of a lambda
/// expression such as
/// \snippet adaptive_tessellation.cpp rule
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Simple_manifolds::Chord_error<Surface>}
/// \cgalHasModels{CGAL::Simple_manifolds::Edge_length<Surface>}
/// \cgalHasModels{CGAL::Simple_manifolds::Mesh_vertex_count<Map>}
/// \cgalHasModels{CGAL::Simple_manifolds::Combined_sizing<Sizings...>}
/// \cgalHasModelsEnd
class TessellationSizing {
public:
  /// Sets `excess[i]` to the excess of the face `faces[i]`.
  /// \pre `excess.size() == faces.size()`
  template <class Atlas>
  void operator()(const CGAL::Simple_manifolds::Domain_triangulation<Atlas>& triangulation,
                  const std::vector<int>& faces, std::vector<double>& excess) const;

  /// The excess of one face.
  template <class Atlas>
  double operator()(const CGAL::Simple_manifolds::Domain_triangulation<Atlas>& triangulation, int face) const;
};
