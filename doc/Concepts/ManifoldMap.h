/// \ingroup PkgSimpleManifoldsConcepts
/// \cgalConcept
///
/// The concept `ManifoldMap` describes a correspondence M: a one to one map between a canonical surface
/// and a triangle mesh in space. It is what a surface is fitted to: points of the domain are sent to the
/// mesh, and vertices and points of faces to the domain.
///
/// Each vertex v of the mesh has a domain point q_v. A point with barycentric coordinates b in the face
/// (u,v,w) corresponds to normalize(b_0 q_u + b_1 q_v + b_2 q_w) on the sphere, and to the linear
/// combination of the copies nearest to each other on the torus and the square. All faces are positively
/// oriented in the domain.
///
/// Vertices and faces are named by their positions, from 0 on, which any built-in integer type may hold. `Mesh_map` also
/// takes the descriptors of its mesh.
///
/// All members are const and may be called from several threads.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Simple_manifolds::Manifold_map<Atlas>}
/// \cgalHasModels{CGAL::Simple_manifolds::Mesh_map<FaceListGraph,Atlas>}
/// \cgalHasModelsEnd
class ManifoldMap {
public:
  /// \name Types
  /// @{

  /// A model of `ManifoldAtlas`.
  typedef unspecified_type Atlas;

  /// The same as `Atlas::Domain_point`.
  typedef unspecified_type Domain_point;

  /// A point of the mesh, with the members `int face` and `Eigen::Vector3d barycentric` (none negative,
  /// sum 1). It can be made from these two in braces: `Location{face, barycentric}`. What `to_mesh()` returns
  /// converts to it.
  typedef unspecified_type Location;

  /// @}
  /// \name The mesh and its domain points
  /// @{

  /// The atlas of the domain.
  const Atlas& atlas() const;
  /// Vertices of the mesh, virtual ones included.
  std::size_t number_of_vertices() const;
  /// Faces of the mesh, all of them triangles, virtual ones included.
  std::size_t number_of_faces() const;
  /// Whether a face is no part of the mesh but closes one of its borders; nothing is fitted to it.
  bool is_virtual(std::size_t f) const;
  /// Whether all faces of a vertex are virtual.
  bool is_virtual_vertex(std::size_t v) const;

  /// The position in space of vertex `v`.
  const Eigen::Vector3d& point(std::size_t v) const;

  /// The vertices of face `f`.
  const CGAL::Simple_manifolds::Triangle& face(std::size_t f) const;

  /// The domain point of vertex `v`.
  const Domain_point& domain_point(std::size_t v) const;

  /// The length that errors are relative to: the diagonal of the bounding box of the mesh.
  double diagonal() const;

  /// @}
  /// \name Operations
  /// @{

  /// The domain point of a point of the mesh.
  Domain_point to_domain(const Location& location) const;

  /// The point of the mesh with the domain point `p`; always exists. Points of an edge or a vertex are
  /// found in any one of its faces.
  Location to_mesh(const Domain_point& p) const;

  /// The same. `face_hint` is a face that may be near, or -1; it changes only the time that it takes,
  /// and the choice between faces of which `p` is a common point.
  Location to_mesh(const Domain_point& p, int face_hint) const;

  /// The position in space of a point of the mesh.
  Eigen::Vector3d position(const Location& location) const;

  /// `position(to_mesh(p))`.
  Eigen::Vector3d operator()(const Domain_point& p) const;

  /// @}
};
