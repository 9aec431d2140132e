/// \ingroup PkgSimpleManifoldsConcepts
/// \cgalConcept
///
/// The concept `ChartEmbedding` describes a function from the unit square, the coordinates (u,v) of one
/// chart, into space. A `Manifold_surface` blends one such function per chart into a surface.
///
/// All members are const and may be called from several threads.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Simple_manifolds::Hierarchical_embedding}
/// \cgalHasModels{CGAL::Simple_manifolds::Patch_stack_embedding}
/// \cgalHasModels{CGAL::Simple_manifolds::Map_embedding<Map>}
/// \cgalHasModelsEnd
class ChartEmbedding {
public:
  /// The number of continuous derivatives on the open square, at least 0.
  int smoothness() const;

  /// The position at `uv`, for all `uv` in the closed unit square.
  Eigen::Vector3d point(const Eigen::Vector2d& uv) const;

  /// Position and derivatives by u and v at `uv`, for all `uv` in the closed unit square.
  /// \tparam Order  the highest order of derivatives that the caller uses, 1 or 2; those of higher order
  ///                must be finite. Where a derivative is not continuous, the one of either side may be
  ///                returned.
  template <int Order = 2>
  CGAL::Simple_manifolds::Jet jet(const Eigen::Vector2d& uv) const;
};
