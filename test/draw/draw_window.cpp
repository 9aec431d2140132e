// Opens the windows of CGAL::draw() for a map and for a surface, takes a picture of each, closes it, and
// looks at the picture: it has to show the colours of several charts.

#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/draw.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SM = CGAL::Simple_manifolds;

namespace {

QImage picture;

// Once the event loop runs: the window is complete by then.
void take_picture_and_close()
{
  QTimer::singleShot(1500, [] {
    for (QWidget* window : QApplication::topLevelWidgets())
      if (window->isVisible()) {
        picture = window->grab().toImage();
        window->close();
      }
    QApplication::quit();
  });
}

// Per chart the share of the coloured pixels whose colour, up to shading, is nearest to the chart's.
std::array<double, 9> shares(const char* name)
{
  std::array<double, 9> pixels{};
  double all = 1;
  for (int y = 0; y < picture.height(); y += 2)
    for (int x = 0; x < picture.width(); x += 2) {
      const QColor q = picture.pixelColor(x, y);
      const Eigen::Vector3d is(q.red(), q.green(), q.blue());
      if (is.maxCoeff() - is.minCoeff() < 30) continue; // background, edges
      const auto likeness = [&](int c) { return is.dot(SM::chart_colour(c).normalized()); };
      int nearest = 0;
      for (int c = 1; c < 9; ++c)
        if (likeness(c) > likeness(nearest)) nearest = c;
      ++pixels[std::size_t(nearest)];
      ++all;
    }
  picture.save(QString(name) + ".png");
  std::cout << name << ", " << picture.width() << " x " << picture.height() << " pixels, shares of charts:";
  for (double& p : pixels) std::cout << ' ' << (p /= all);
  std::cout << std::endl;
  return pixels;
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(take_picture_and_close)

int main()
{
  const SM::Tile_grid<SM::Sphere_atlas> grid(8);
  const std::vector<Eigen::Vector3d> points(grid.domain_points().begin(), grid.domain_points().end());
  const SM::Manifold_map<SM::Sphere_atlas> map(points, SM::triangulate(grid, points), grid.domain_points(),
                                               points.size());
  CGAL::draw(map);
  const std::array<double, 9> of_map = shares("draw_map");
  const bool shows_map = std::count_if(of_map.begin(), of_map.end(), [](double p) { return p > 0.02; }) >= 3;

  // a square patch that is bent
  SM::Hierarchical_embedding::Level level{4, {}, {}};
  for (int i = 0; i < 49; ++i) {
    level.indices.push_back(i);
    level.coefficients.emplace_back(i / 7, i % 7, std::sin(i / 7));
  }
  CGAL::draw(SM::Manifold_surface<SM::Plane_atlas>({SM::Hierarchical_embedding(3, {level})}));
  const bool shows_surface = shares("draw_surface")[0] > 0.5; // where it shines it is lighter
  return shows_map && shows_surface ? EXIT_SUCCESS : EXIT_FAILURE;
}
