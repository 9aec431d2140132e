// Opens the windows of CGAL::draw() for a map and for a surface, takes a picture of each, closes it, and
// looks at the picture: it has to show the colours of several charts.

#include <CGAL/Simple_manifolds/draw.h>
#include <CGAL/Simple_manifolds/tessellation/tessellate.h>

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include <cmath>
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

// The number of chart colours, up to shading, that a good share of the picture has.
int colours_shown()
{
  int shown = 0;
  for (int c = 0; c < 9; ++c) {
    const Eigen::Vector3d wanted = SM::chart_colour(c).normalized();
    int pixels = 0;
    for (int y = 0; y < picture.height(); y += 2)
      for (int x = 0; x < picture.width(); x += 2) {
        const QColor q = picture.pixelColor(x, y);
        const Eigen::Vector3d is(q.red(), q.green(), q.blue());
        pixels += is.maxCoeff() - is.minCoeff() > 30 && is.normalized().dot(wanted) > 0.998;
      }
    shown += pixels > 100;
  }
  return shown;
}

int drawn_colours(const char* name)
{
  const int shown = colours_shown();
  picture.save(QString(name) + ".png");
  std::cout << name << ": " << picture.width() << " x " << picture.height() << " pixels, " << shown
            << " chart colours\n";
  return shown;
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
  const bool shows_map = drawn_colours("draw_map") >= 3;

  // a square patch that is bent
  SM::Hierarchical_embedding::Level level{4, {}, {}};
  for (int i = 0; i < 49; ++i) {
    level.indices.push_back(i);
    level.coefficients.emplace_back(i / 7, i % 7, std::sin(i / 7));
  }
  CGAL::draw(SM::Manifold_surface<SM::Plane_atlas>({SM::Hierarchical_embedding(3, {level})}));
  const bool shows_surface = drawn_colours("draw_surface") == 1;
  return shows_map && shows_surface ? EXIT_SUCCESS : EXIT_FAILURE;
}
