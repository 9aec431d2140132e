// Copyright (c) 2026 The Simple_manifolds authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Simple_manifolds authors

#ifndef CGAL_SIMPLE_MANIFOLDS_IO_PNG_IMAGES_H
#define CGAL_SIMPLE_MANIFOLDS_IO_PNG_IMAGES_H

#include <CGAL/Simple_manifolds/Error.h>
#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/tessellation/Chart_textures.h>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

/// \file
/// Needs libpng (the target `CGAL::Simple_manifolds_PNG` of CMake).

namespace CGAL {
namespace Simple_manifolds {

namespace internal {

// The contents of a PNG file, 8 bits per channel, rows from the top.
inline std::string png(int width, int height, int channels, const std::vector<unsigned char>& pixels)
{
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(width);
  image.height = png_uint_32(height);
  image.format = channels == 1 ? PNG_FORMAT_GRAY : channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, &bytes[0], &size, 0, pixels.data(), 0, nullptr))
    throw Error(Error_code::cannot_write, std::string("an image cannot be made: ") + image.message);
  bytes.resize(size);
  return bytes;
}

} // namespace internal

/// \ingroup PkgSimpleManifoldsIO
///
/// The images of the charts as the contents of PNG files, one per chart: u to the right, v upwards. Values 0
/// to 1 become 0 to 255, others the nearest of these; the colours are sRGB. Each image covers the whole open
/// unit square, so that filters at the border of a tile find the right texels around it.
///
/// \tparam Channels  1 (grey), 3 (red, green, blue) or 4 (with opacity)
/// \throw Error (`cannot_write`) when libpng cannot make the image
template <class Atlas, int Channels, class Bump>
std::vector<std::string> png_images(const Chart_textures<Atlas, Channels, Bump>& textures)
{
  static_assert(Channels == 1 || Channels == 3 || Channels == 4, "grey, RGB or RGBA");
  const int n = textures.resolution();
  std::vector<std::string> images;
  std::vector<unsigned char> pixels;
  for (int c = 0; c < textures.atlas().number_of_charts(); ++c) {
    pixels.clear();
    for (int j = n - 1; j >= 0; --j)
      for (int i = 0; i < n; ++i) {
        const auto x = textures.texel(c, i, j);
        for (int k = 0; k < Channels; ++k) {
          const double in_range = x[k] > 0 ? (std::min)(x[k], 1.) : 0.; // NaN too
          pixels.push_back(static_cast<unsigned char>(std::lround(255 * in_range)));
        }
      }
    images.push_back(internal::png(n, n, Channels, pixels));
  }
  return images;
}

/// \ingroup PkgSimpleManifoldsIO
///
/// Writes the images of the charts as chart0.png, chart1.png, ... into a folder: all of them, or none.
/// \throw IO_error (`cannot_write`)
inline void write_images(const std::string& folder, const std::vector<std::string>& images)
{
  Atomic_folder output(folder);
  for (std::size_t c = 0; c < images.size(); ++c) {
    Atomic_file image(output.file("chart" + std::to_string(c) + ".png"));
    image.stream() << images[c];
    image.commit();
  }
  output.commit();
}

} // namespace Simple_manifolds
} // namespace CGAL

#endif // CGAL_SIMPLE_MANIFOLDS_IO_PNG_IMAGES_H
