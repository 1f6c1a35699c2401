// One stroke's polyline in the making: pieces between vertices, which can be made finer.
#ifndef oversketch_kernels_planar_pieces_h
#define oversketch_kernels_planar_pieces_h

#include "Planar/approximate.h"
#include "Stroke/polyline.h"

namespace oversketch
{

// From one vertex to the next, numbers of samples; on a closed stroke `to` may be past its last one, by whole
// turns.
struct Piece
{
  int from = 0, to = 0;
  int halvings = 0; // of delta, beyond those that were handed back
};

class PieceList
{
public:
  // Samples of the stroke, a joined end where it joins; arc lengths are those of `drawn`. thickness: of each
  // sample, D [world]; none where delta is fixed. forced: samples that are vertices in any case. splits: of
  // this stroke.
  PieceList(Polyline samples,
    const DrawnStroke& drawn,
    std::vector<double> thickness,
    const std::vector<int>& forced,
    std::vector<StrokeSplit> splits,
    double longest,
    const ApproximationRules& rules);

  const std::vector<Piece>& pieces() const { return this->Pieces; }
  const Vector2& sample(int i) const { return this->Samples[i % this->count()]; }
  int count() const { return static_cast<int>(this->Samples.size()); }
  // The vertices, ascending.
  std::vector<int> vertices() const;
  // Halves delta in a piece; splits it where that allows or demands. Its parts take its place.
  enum class Halved
  {
    Split,
    Same, // not yet
    Spent // no sample of it is off its segment
  };
  Halved halve(int piece);
  // Halves pieces longer than `least` until none is so near to a place as `share` of its own length.
  void makeRoom(const Vector2& place, double share, double least);
  // Splits a lone piece at its middle sample.
  void divide();
  // Whether a place lies between a piece and its samples (even-odd).
  bool leavesOut(int piece, const Vector2& place) const;

private:
  struct Farthest
  {
    int sample = -1;
    double distance = 0.0;
  };
  Farthest farthest(const Piece& piece) const;
  double lengthTo(int sample) const;
  int halvingsOf(const Piece& piece) const;
  double delta(const Piece& piece) const;
  double longestArc(const Piece& piece) const;
  int middle(const Piece& piece) const;
  std::vector<int> anchors(const std::vector<int>& forced) const;
  void split(int piece, int sample);
  void settle(int begin, int end);

  Polyline Samples;
  bool Closed;
  std::vector<double> Lengths, Thickness;
  std::vector<StrokeSplit> Splits;
  double Longest;
  ApproximationRules Rules;
  std::vector<Piece> Pieces;
};

// Source: image-assisted modelling, section 6, step 1, on a resampled stroke. A sample is near a corner where
// the chord of the four samples before it and that of the four after it differ by more than `angle` [rad];
// consecutive ones, and runs of them fewer than four samples apart, are one corner: the sample that turns
// most, of several the first. Round a closed stroke (its first point not repeated) everything is cyclic, and
// one that turns like that all along, a small circle, has no corners. The first and last four samples of an
// open stroke are none. Ascending numbers of samples.
std::vector<int> corners(const Polyline& stroke, bool closed, double angle = 0.78539816339744831);

} // namespace oversketch
#endif
