// Regions round curves that are edges; the facts of editors.md, section 5, are tested with the filter.
#include "Region/enclose.h"

#include "Harness/enclosures.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Enclosed enclosed(const Enclosure& scene)
{
  return enclose(scene.mesh, buildAdjacency(scene.mesh), scene.reference, scene.boundary, {});
}

void expectRefused(const Enclosure& scene, Failure failure, const std::string& words)
{
  try
  {
    enclosed(scene);
    ADD_FAILURE() << "not refused: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), failure) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(Enclose, TheReferenceMayBeAnywhereInside)
{
  // A curve of one edge, and one whose vertices are no neighbours, enclose the same.
  Enclosure scene = sheet(8);
  const std::vector<char> faces = enclosed(scene).faces;
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 2), 6 * 8 * 8);
  scene.reference = { scene.reference[0], scene.reference[1] };
  EXPECT_EQ(enclosed(scene).faces, faces);
  scene = sheet(8);
  scene.reference = { scene.reference.front(), scene.reference.back() };
  EXPECT_EQ(enclosed(scene).faces, faces);
}

TEST(Enclose, VerticesOnTheMeshsBorderStay)
{
  // All of a sheet but its outermost rows would be over 80 %; half of it is not.
  Enclosure scene = sheet(8);
  std::vector<int> border;
  const Adjacency adjacency = buildAdjacency(scene.mesh);
  // From the hexagon's upper corners to the sheet's, and along the sheet's upper side.
  const auto at = [&](double x, double row)
  {
    const Vector3 wanted(x, std::sqrt(0.75) * row, 0.0);
    return static_cast<int>(
      std::min_element(scene.mesh.points.begin(),
        scene.mesh.points.end(),
        [&](const Vector3& a, const Vector3& b) { return (a - wanted).norm() < (b - wanted).norm(); }) -
      scene.mesh.points.begin());
  };
  for (int k = 0; k <= 12; ++k)
  {
    border.push_back(at(12.0 - 0.5 * k, k)); // up the sheet's right side
  }
  for (int k = 1; k <= 12; ++k)
  {
    border.push_back(at(6.0 - k, 12));
  }
  for (int k = 11; k >= 0; --k)
  {
    border.push_back(at(-12.0 + 0.5 * k, k));
  }
  for (int k = 1; k <= 24; ++k)
  {
    border.push_back(at(-12.0 + k, 0));
  }
  scene.boundary = border;
  scene.reference = { at(-0.5, 5), at(0.5, 5) };
  const Enclosed half = enclosed(scene);
  for (int v = 0; v < scene.mesh.vertexCount(); ++v)
  {
    EXPECT_FALSE(half.vertices[v] == 2 && adjacency.borderVertex[v]);
  }
  EXPECT_EQ(std::count(half.faces.begin(), half.faces.end(), 2), 3 * 12 * 12);
}

TEST(Enclose, RefusesByName)
{
  Enclosure open = sheet(8);
  open.boundary.pop_back();
  expectRefused(open, Failure::BadStroke, "not closed");

  Enclosure leaking = sheet(8);
  leaking.boundary.erase(leaking.boundary.begin() + 2);
  expectRefused(leaking, Failure::BadStroke, "leaves the edges");

  Enclosure point = sheet(8);
  point.reference.resize(1);
  expectRefused(point, Failure::BadStroke, "fewer than two");

  Enclosure across = sheet(8);
  const int corner = across.boundary.front();
  across.reference.push_back(corner);
  expectRefused(across, Failure::BadRegion, "not all inside");

  // Round nearly all of the sheet.
  Enclosure large = sheet(40);
  expectRefused(large, Failure::BadRegion, "% of the surface");

  // A sphere within the boundary besides, joined at nothing, is another part: it changes nothing.
  Enclosure two = sheet(8);
  two.mesh = joined(two.mesh, icosphere(1), Vector3(0, 0, 3));
  EXPECT_NO_THROW(enclosed(two));
}
