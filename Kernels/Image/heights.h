// A terrain from a height image: a coarse grid of quads, each two triangles, and the height at any place.
//
// Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. IV: the base mesh is a grid
// over the image, which the user makes as coarse as he likes; finer triangles read the image anew. Silent
// there, and chosen here: heights between samples are bilinear; samples that are missing in narrow places are
// filled, and quads over those still missing are left out.
#ifndef oversketch_kernels_image_heights_h
#define oversketch_kernels_image_heights_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// Row by row from the lower left.
struct HeightImage
{
  int width = 0, height = 0;   // samples
  std::vector<double> samples; // gray; not finite: missing
  Vector2 spacing{ 1.0, 1.0 }; // between samples [model length]

  // Bilinear, at so many samples from the lower left, clamped to the image; NaN where a sample that counts is
  // missing.
  double at(double column, double row) const;
};

struct FilledSamples
{
  std::size_t filled = 0; // samples
  std::size_t left = 0;   // that are missing still
};

// Fills missing samples that lie in no block of 3 x 3 missing ones. Each of them has a known sample beside
// it, at the image's border at most two away, and is given the height there of the plane that fits the
// samples up to three away best, by weights that fall with the square of their distance. What is made of a
// plane is exact, but where all of these lie on one line, which tells no slope across it.
FilledSamples fillNarrowGaps(HeightImage& image, const Context& context = Context());

struct TerrainRules
{
  // Quads along x and y. 0: 64 along the longer side, or as many as make quads square beside the other
  // number.
  int columns = 0, rows = 0;
  // Sides of a quad [model length]; 0: as long as the image is by its spacing.
  Vector2 quad{ 0.0, 0.0 };
  double scale = 1.0;  // model length per unit of gray
  double offset = 0.0; // z where gray is 0 [model length]
};

class Terrain
{
public:
  // Throws Error(Failure::BadMesh) for an image with fewer than two samples in a row or column, or of another
  // size than it says, a rule that is not finite or negative, and more than eight million quads.
  Terrain(HeightImage image, const TerrainRules& rules);

  int columns() const { return this->Columns; }
  int rows() const { return this->Rows; }

  // z at (x, y) in the terrain, clamped to its rim; NaN where a sample is missing.
  double heightAt(double x, double y) const;

  // Vertices (i, j) at (i quad.x, j quad.y), row by row. Quad by quad two triangles, cut from lower left to
  // upper right, each with that cut between its second and third vertex. Quads over a missing sample are left
  // out, and then, so that the mesh is a manifold, of two that meet at a corner alone the one with fewer
  // neighbours, or the later one, until none do; vertices without a quad are left out too. Throws
  // Error(Failure::BadMesh) where no quad is left.
  Mesh baseMesh(const Context& context = Context()) const;

private:
  // Place of a grid line in samples.
  double column(int i) const;
  double row(int j) const;
  std::vector<char> completeQuads(const Context& context) const;
  void dropCornerJoints(std::vector<char>& kept) const;
  bool cornerJoint(const std::vector<char>& kept, int i, int j) const;

  HeightImage Image;
  int Columns, Rows;
  Vector2 Quad;
  double Scale, Offset;
};

} // namespace oversketch
#endif
