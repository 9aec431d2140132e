// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H
#define CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H

#include <CGAL/Simple_manifolds/internal/named_parameters.h>

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/IO/internal/Document_writer.h>
#include <CGAL/Simple_manifolds/IO/internal/Embedding_io.h>
#include <CGAL/Simple_manifolds/IO/internal/Json_field.h>
#include <CGAL/Simple_manifolds/IO/internal/atlas_numbers.h>
#include <CGAL/Simple_manifolds/IO/internal/file_contents.h>
#include <CGAL/Simple_manifolds/IO/internal/parse_document.h>
#include <CGAL/Simple_manifolds/atlas/Bump_functions.h>
#include <CGAL/Simple_manifolds/atlas/canonical_surfaces.h>
#include <CGAL/Simple_manifolds/embedding/Hierarchical_embedding.h>
#include <CGAL/Simple_manifolds/embedding/Manifold_surface.h>
#include <CGAL/Simple_manifolds/embedding/Patch_stack_embedding.h>
#include <CGAL/Simple_manifolds/embedding/fit_mesh_surface.h>

#include <CGAL/assertions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// \file

namespace CGAL {
namespace Simple_manifolds {

/// \ingroup PkgSimpleManifoldsIO
///
/// What a surface file says before its charts: which type of surface it holds.
struct Surface_header {
  std::string atlas;  ///< the name of a canonical surface
  std::string bump;   ///< `smoothstep`, `bspline` or `polynomial`
  int smoothness = 0; ///< of the bump
  int degree = 0;     ///< of the splines
  /// The root mean square error that it was fitted to, fraction of the diagonal; 0: the file does not say it.
  double tolerance = 0;
};

namespace internal {

inline constexpr const char* surface_format = "simple_manifolds_surface";
inline constexpr const char* surfaces_format = "simple_manifolds_surfaces"; // of the components of a mesh
inline constexpr int surface_version = 1;

// Whether it is a document of the surfaces of components.
inline bool has_parts(const Json_field& j)
{
  return j.has("format") && j["format"].text() == surfaces_format;
}

inline Surface_header header_of_json(const Json_field& j)
{
  if (!j.has("format") || j["format"].text() != surface_format)
    j.fail(std::string("no surface: the key \"format\" does not say \"") + surface_format + '"');
  if (j["version"].integer(0, 1 << 30) != surface_version)
    j["version"].fail("only version " + std::to_string(surface_version) + " can be read");
  Surface_header header{j["atlas"].text(), j["bump"]["type"].text(), j["bump"]["smoothness"].integer(0, 99),
                        j["degree"].integer(1, maximum_spline_degree)};
  if (j.has("tolerance")) header.tolerance = j["tolerance"].number();
  if (!(header.tolerance >= 0)) j["tolerance"].fail("a number from 0 on is expected");
  return header;
}

template <class Atlas>
Atlas atlas_of_json(const Json_field& j)
{
  return atlas_of_numbers<Atlas>([&j](const char* key) { return j[key].integer(0, 1 << 30); },
                                 [&j](const std::string& message) { j.fail(message); });
}

// The bump of a file: the smoothness of most is part of their type.
template <class Bump>
Bump bump_of_smoothness(int k)
{
  if constexpr (std::is_same_v<Bump, Any_smoothstep_bump>)
    return Bump((std::min)(k, Bump::largest_smoothness));
  else
    return Bump();
}

// share: of how many surfaces this is one, which share the memory.
template <class Surface>
Surface surface_of_json(const Json_field& j, int share = 1)
{
  using Atlas = typename Surface::Atlas;
  using Bump = typename Surface::Bump;
  const Surface_header header = header_of_json(j);
  if (header.atlas != Atlas::name)
    j["atlas"].fail('"' + header.atlas + "\" where \"" + Atlas::name + "\" is expected");
  const Bump bump = bump_of_smoothness<Bump>(header.smoothness);
  if (header.bump != Bump::type || header.smoothness != bump.smoothness)
    j["bump"].fail(header.bump + " of smoothness " + std::to_string(header.smoothness) + " where " +
                   Bump::type + " of smoothness " + std::to_string(int(bump.smoothness)) + " is expected");
  const Json_field charts = j["charts"];
  const Atlas atlas = atlas_of_json<Atlas>(j);
  charts.require_size(atlas.number_of_charts());
  using Chart_embedding = typename Surface::Chart_embedding;
  std::vector<Chart_embedding> embeddings;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const Json_field list = charts[c]["patches"];
    if (list.size() == 0) list.fail("at least one patch is expected");
    embeddings.push_back(
      Embedding_io<Chart_embedding>::read(list, header.degree, share * atlas.number_of_charts()));
  }
  return Surface(std::move(embeddings), bump, atlas);
}

// The tolerance among the parameters of writers.
template <class NamedParameters>
double tolerance_of_file(const NamedParameters& np)
{
  const double tolerance = parameter(np, internal_np::rms_error, 0.);
  CGAL_precondition(tolerance >= 0 && std::isfinite(tolerance));
  return tolerance;
}

// The document of a surface, with its name if it is one of several. `tolerance`: none if it is 0.
template <class Atlas, class ChartEmbedding, class Bump>
void write_surface_object(Document_writer& out, const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
                          double tolerance, const std::optional<std::string>& name = std::nullopt)
{
  using Io = Embedding_io<ChartEmbedding>;
  const int degree = Io::degree(surface.chart_embedding(0));
  const std::vector<Atlas_number> numbers = numbers_of(surface.atlas());
  out.object(6 + numbers.size() + (name ? 1 : 0) + (tolerance > 0 ? 1 : 0));
  if (name) out.entry("name", valid_text(*name));
  out.entry("format", surface_format);
  out.entry("version", surface_version);
  out.entry("atlas", Atlas::name);
  for (const Atlas_number& n : numbers) out.entry(n.key.c_str(), n.value);
  out.value("bump");
  out.object(2);
  out.entry("type", Bump::type);
  out.entry("smoothness", int(surface.bump().smoothness));
  out.entry("degree", degree);
  if (tolerance > 0) out.entry("tolerance", tolerance);
  out.value("charts");
  out.array(surface.atlas().number_of_charts());
  for (int c = 0; c < surface.atlas().number_of_charts(); ++c) {
    const ChartEmbedding& embedding = surface.chart_embedding(c);
    CGAL_precondition(Io::degree(embedding) == degree);
    const std::vector<Patch_record> patches = Io::patches(embedding);
    out.object(1);
    out.value("patches");
    out.array(patches.size());
    for (const Patch_record& patch : patches) write_patch(out, patch);
  }
}

inline bool is_cbor_name(const std::string& file)
{
  return std::filesystem::path(file).extension() == ".cbor";
}

// A surface over whichever canonical surface the document names.
template <class Bump, class ChartEmbedding>
Any_surface<Bump, ChartEmbedding> any_surface_of_json(const Json_field& j, int share = 1)
{
  const std::string atlas = header_of_json(j).atlas;
  std::optional<Any_surface<Bump, ChartEmbedding>> surface;
  Canonical_surfaces::visit_name(atlas, [&](auto type) {
    using Surface = Manifold_surface<typename decltype(type)::Atlas, ChartEmbedding, Bump>;
    surface.emplace(surface_of_json<Surface>(j, share));
  });
  if (!surface) j["atlas"].fail("\"" + atlas + "\" is none of " + Canonical_surfaces::names());
  return std::move(*surface);
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes a surface, version 1: the atlas, the bump, the degree, and per chart its patches with their
/// coefficients; of a `Hierarchical_embedding` one patch per level. As JSON, where numbers have as many
/// digits as they need to be read back bit for bit; as CBOR (RFC 8949), the same document in binary, if
/// the name of the file ends in `.cbor`.
///
/// \tparam ChartEmbedding  `Hierarchical_embedding` or `Patch_stack_embedding`
/// \param np  named parameters
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{rms_error} \cgalParamDescription{the tolerance that the surface was fitted to, as the fit takes
///     it: the file says it, so that programs know how fine a tessellation has to be, see `Surface_header`}
///     \cgalParamType{`double`, not negative} \cgalParamDefault{0: the file says nothing} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre all splines have one degree, and finite coefficients
/// \throw IO_error (`cannot_write`), std::bad_alloc; a file that was there before is then as it was
template <class Atlas, class ChartEmbedding, class Bump,
          class NamedParameters = parameters::Default_named_parameters>
void write_surface(const std::string& file, const Manifold_surface<Atlas, ChartEmbedding, Bump>& surface,
                   const NamedParameters& np = parameters::default_values())
{
  CGAL_SIMPLE_MANIFOLDS_KNOWN_PARAMETERS(NamedParameters, "rms_error");
  const double tolerance = internal::tolerance_of_file(np);
  const bool is_cbor = internal::is_cbor_name(file);
  Atomic_file output(file);
  internal::Document_writer out(output.stream(), is_cbor);
  internal::write_surface_object(out, surface, tolerance);
  if (!is_cbor) output.stream() << '\n';
  output.commit();
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Says what a surface file, JSON or CBOR, holds, so that the type to read it with can be chosen; of a file of several
/// surfaces, what it says of the first.
/// \throw IO_error when the file is missing or no surface
inline Surface_header read_surface_header(const std::string& file)
{
  const internal::Document document{internal::parse_document(file, internal::file_contents(file))};
  const internal::Json_field root(file, document.root);
  if (!internal::has_parts(root)) return internal::header_of_json(root);
  const internal::Json_field parts = root["parts"];
  if (parts.size() == 0) parts.fail("at least one surface is expected");
  return internal::header_of_json(parts[std::size_t(0)]);
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a surface of a known type, from JSON or CBOR. Its controls may take 512 MB of memory, and 8 kB for each
/// coefficient in the file: more than fitted surfaces need, but a short file cannot fill the memory.
/// \tparam Surface  a `Manifold_surface` with `Hierarchical_embedding`, which takes the files whose patches
///                  are grids of the whole unit square, each 1, 2, 4, ... times as fine as the coarsest, or
///                  with `Patch_stack_embedding`, which takes all files, but holds all controls of a grid, so
///                  that those of very fine hierarchies are too large for it
/// \throw IO_error when the file is missing, no surface, damaged, of another atlas, bump or kind of patch, or asks
///                  for too much memory
template <class Surface>
Surface read_surface(const std::string& file)
{
  const internal::Document document{internal::parse_document(file, internal::file_contents(file))};
  return internal::surface_of_json<Surface>(internal::Json_field(file, document.root));
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Reads a surface over whichever canonical surface the file names, with the limits of `read_surface()`.
/// \tparam Bump            the bump of the file, or `Any_smoothstep_bump`
/// \tparam ChartEmbedding  as for `read_surface()`
/// \return an `Any_surface<Bump, ChartEmbedding>`
/// \throw IO_error as `read_surface()`
template <class Bump = Smoothstep_bump<2>, class ChartEmbedding = Hierarchical_embedding>
auto read_any_surface(const std::string& file)
{
  const internal::Document document{internal::parse_document(file, internal::file_contents(file))};
  return internal::any_surface_of_json<Bump, ChartEmbedding>(internal::Json_field(file, document.root));
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_SURFACE_IO_H
