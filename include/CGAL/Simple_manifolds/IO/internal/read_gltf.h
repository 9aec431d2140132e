// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GLTF_H
#define CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GLTF_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/internal/Binary_scanner.h>
#include <CGAL/Simple_manifolds/IO/internal/File_mesh.h>
#include <CGAL/Simple_manifolds/IO/internal/Property_rows.h>
#include <CGAL/Simple_manifolds/Mesh_properties.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace CGAL {
namespace Simple_manifolds {
namespace internal {

// The meshes of a scene of assimp as one soup: every instance of a mesh in its place.
class Assimp_scene {
public:
  explicit Assimp_scene(const aiScene& scene) : scene_(scene)
  {
    add(*scene.mRootNode, Eigen::Matrix4d::Identity());
  }

  File_mesh mesh() &&
  {
    const std::size_t n = mesh_.points.size();
    normals_.add_to(mesh_.properties.vertex, n);
    colours_.add_to(mesh_.properties.vertex, n);
    uv_.add_to(mesh_.properties.vertex, n);
    if (scene_.mNumAnimations > 0) mesh_.properties.dropped.push_back("animations");
    mesh_.is_single_precision = true;
    return std::move(mesh_);
  }

private:
  static Eigen::Matrix4d matrix(const aiMatrix4x4& m)
  {
    Eigen::Matrix4d x;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned k = 0; k < 4; ++k) x(i, k) = double(m[i][k]);
    return x;
  }

  void add(const aiNode& node, const Eigen::Matrix4d& parent)
  {
    const Eigen::Matrix4d place = parent * matrix(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], place);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], place);
  }

  void add(const aiMesh& mesh, const Eigen::Matrix4d& place)
  {
    const std::size_t base = mesh_.points.size();
    const Eigen::Matrix3d linear = place.topLeftCorner<3, 3>();
    const bool is_mirrored = linear.determinant() < 0;
    Eigen::Matrix3d of_normals; // the matrix of the cofactors
    for (int k = 0; k < 3; ++k) of_normals.col(k) = linear.col((k + 1) % 3).cross(linear.col((k + 2) % 3));
    if (is_mirrored) of_normals = -of_normals;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      mesh_.points.push_back(linear * Eigen::Vector3d(double(p.x), double(p.y), double(p.z)) +
                             place.topRightCorner<3, 1>());
      if (mesh.HasNormals()) {
        const aiVector3D& n = mesh.mNormals[v];
        const Eigen::Vector3d normal =
          (of_normals * Eigen::Vector3d(double(n.x), double(n.y), double(n.z))).normalized();
        normals_.put(base + v, normal.data(), normal.data() + 3);
      }
      if (mesh.HasVertexColors(0)) {
        const aiColor4D& c = mesh.mColors[0][v];
        const std::array<double, 4> colour = {double(c.r), double(c.g), double(c.b), double(c.a)};
        colours_.put(base + v, colour.begin(), colour.end());
      }
      if (mesh.HasTextureCoords(0)) {
        const aiVector3D& t = mesh.mTextureCoords[0][v];
        const std::array<double, 2> uv = {double(t.x), double(t.y)};
        uv_.put(base + v, uv.begin(), uv.end());
      }
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) {
        mesh_.warn(Read_warning::SKIPPED_ELEMENTS,
                   std::string("point or line of the mesh \"") + mesh.mName.C_Str() + '"');
        continue;
      }
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        mesh_.add_corner(int(base + face.mIndices[is_mirrored ? face.mNumIndices - 1 - k : k]));
      mesh_.end_face();
    }
  }

  const aiScene& scene_;
  File_mesh mesh_;
  Property_rows normals_{"normal", 3, Scalar_type::FLOAT32}, colours_{"colour", 4, Scalar_type::FLOAT32},
    uv_{"uv", 2, Scalar_type::FLOAT32};
};

// Assimp takes the memory that a binary glTF announces before it looks whether there is so much.
inline void require_complete_glb(const std::string& file, std::string_view bytes)
{
  if (bytes.substr(0, 4) != "glTF") return;
  Binary_scanner in(file, bytes, Binary_scanner::LITTLE_ENDIAN_BYTES);
  in.skip(4, "the header");
  const bool has_chunks = in.number(Scalar_type::UINT32, "the version") != 1;
  if (in.number(Scalar_type::UINT32, "the size of the file") > double(bytes.size()))
    throw IO_error(Error_code::syntax_error, file,
                   "the file is cut off: it announces more bytes than it has");
  do {
    const double size = in.number(Scalar_type::UINT32, "the size of a chunk");
    in.skip(4, "the kind of a chunk");
    in.skip(std::size_t(size), "a chunk");
  } while (has_chunks && in.bytes_left() >= 8);
}

// A glTF document, text or binary, by assimp. Others to which it refers are found beside `file`, unless it is to be read
// from the bytes.
inline File_mesh read_gltf(const std::string& file, std::string_view bytes, bool is_from_bytes)
{
  require_complete_glb(file, bytes);
  constexpr unsigned flags = aiProcess_ValidateDataStructure;
  const char* const extension = bytes.substr(0, 4) == "glTF" ? "glb" : "gltf";
  const aiScene* const imported =
    is_from_bytes ? aiImportFileFromMemory(bytes.data(), unsigned(bytes.size()), flags, extension)
                  : aiImportFile(file.c_str(), flags);
  const std::unique_ptr<const aiScene, void (*)(const aiScene*)> scene(imported, aiReleaseImport);
  if (!scene || !scene->mRootNode) {
    std::string reason = aiGetErrorString();
    for (char& c : reason)
      if (c < ' ') c = ' ';
    throw IO_error(Error_code::syntax_error, file, "assimp cannot read it: " + reason);
  }
  return Assimp_scene(*scene).mesh();
}

} // namespace internal
} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_INTERNAL_READ_GLTF_H
