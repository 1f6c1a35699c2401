#include "Planar/pieces.h"

#include "Mesh/nearest.h"
#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr int cornerReach = 4; // samples, 0.02 of the canvas's longest side

} // namespace

std::vector<int> corners(const Polyline& stroke, bool closed, double angle)
{
  const int count = static_cast<int>(stroke.size());
  std::vector<double> turns(count, 0.0);
  const int first = closed ? 0 : cornerReach, end = closed ? count : count - cornerReach;
  if (count <= 2 * cornerReach)
  {
    return {};
  }
  for (int i = first; i < end; ++i)
  {
    const Vector2 &before = stroke[(i - cornerReach + count) % count],
                  &after = stroke[(i + cornerReach) % count];
    turns[i] = std::abs(turnAngle(stroke[i] - before, after - stroke[i]));
  }
  // A cyclic walk begins behind a gap between two runs, so that no run goes over its end.
  int start = 0;
  if (closed)
  {
    int calm = 0;
    while (start < 2 * count && calm < cornerReach - 1)
    {
      calm = turns[start % count] > angle ? 0 : calm + 1;
      ++start;
    }
    if (calm < cornerReach - 1)
    {
      return {};
    }
  }
  std::vector<int> result;
  int last = -cornerReach; // of the walk, the last sample near a corner
  for (int i = 0; i < count; ++i)
  {
    const int sample = (start + i) % count;
    if (!(turns[sample] > angle))
    {
      continue;
    }
    if (result.empty() || i - last >= cornerReach)
    {
      result.push_back(sample);
    }
    else if (turns[sample] > turns[result.back()])
    {
      result.back() = sample;
    }
    last = i;
  }
  std::sort(result.begin(), result.end());
  return result;
}

namespace
{

constexpr double sampleSpacing = 0.005; // h, of L
constexpr double leastArc = 8.0;        // h

int farthestFrom(const Vector2& place, const Polyline& samples)
{
  int best = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    best =
      (samples[i] - place).squaredNorm() > (samples[best] - place).squaredNorm() ? static_cast<int>(i) : best;
  }
  return best;
}

} // namespace

PieceList::PieceList(Polyline samples,
  const DrawnStroke& drawn,
  std::vector<double> thickness,
  const std::vector<int>& forced,
  std::vector<StrokeSplit> splits,
  double longest,
  const ApproximationRules& rules)
  : Samples(std::move(samples))
  , Closed(drawn.closed)
  , Lengths(arcLengths(drawn.points, drawn.closed))
  , Thickness(std::move(thickness))
  , Splits(std::move(splits))
  , Longest(longest)
  , Rules(rules)
{
  const std::vector<int> ends = this->anchors(forced);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    this->Pieces.push_back({ ends[i], ends[i + 1] });
  }
  this->settle(0, static_cast<int>(this->Pieces.size()));
  while (this->Closed && this->Pieces.size() < 3)
  {
    int widest = -1;
    Farthest most;
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      const Farthest here = this->farthest(this->Pieces[i]);
      if (here.sample >= 0 && here.distance > most.distance)
      {
        widest = static_cast<int>(i);
        most = here;
      }
    }
    if (widest < 0)
    {
      break; // all on one line
    }
    this->split(widest, most.sample);
  }
}

// The first vertices, in the stroke's order; of a closed one the first again at the end.
std::vector<int> PieceList::anchors(const std::vector<int>& forced) const
{
  std::vector<int> found = corners(this->Samples, this->Closed, this->Rules.cornerAngle);
  if (this->Closed && found.empty())
  {
    Vector2 middle = Vector2::Zero();
    for (const Vector2& p : this->Samples)
    {
      middle += p / this->count();
    }
    found.push_back(farthestFrom(middle, this->Samples));
  }
  if (this->Closed && found.size() == 1)
  {
    found.push_back(farthestFrom(this->Samples[found.front()], this->Samples));
  }
  if (!this->Closed)
  {
    found.insert(found.end(), { 0, this->count() - 1 });
  }
  found.insert(found.end(), forced.begin(), forced.end());
  sortUnique(found);
  if (this->Closed)
  {
    found.push_back(found.front() + this->count());
  }
  return found;
}

double PieceList::lengthTo(int sample) const
{
  const int turns = sample / this->count();
  return this->Lengths[sample % this->count()] + (turns > 0 ? turns * this->Lengths.back() : 0.0);
}

// How often delta is halved in it because it, or a part of it, was handed back.
int PieceList::halvingsOf(const Piece& piece) const
{
  const double from = this->lengthTo(piece.from), to = this->lengthTo(piece.to);
  const double least = 1e-6 * sampleSpacing * this->Longest; // that two intervals must have in common
  int most = 0;
  for (const StrokeSplit& split : this->Splits)
  {
    for (const double shift : { -1.0, 0.0, 1.0 })
    {
      const double by = this->Closed ? shift * this->Lengths.back() : 0.0;
      if (std::min(to, split.end + by) - std::max(from, split.start + by) > least)
      {
        most = std::max(most, split.halvings);
      }
    }
  }
  return most + piece.halvings;
}

double PieceList::delta(const Piece& piece) const
{
  const double most = this->Rules.tolerance * this->Longest;
  double result = most;
  if (!this->Thickness.empty())
  {
    for (int i = piece.from; i <= piece.to; ++i)
    {
      result = std::min(result, 0.25 * this->Thickness[i % this->count()]);
    }
    result = std::min(most, std::max(result, 0.5 * sampleSpacing * this->Longest));
  }
  return std::ldexp(result, -this->halvingsOf(piece));
}

// How long it may be, see approximate.h.
double PieceList::longestArc(const Piece& piece) const
{
  if (this->Closed || this->Thickness.empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(
    this->Thickness[static_cast<std::size_t>(this->middle(piece))], leastArc * sampleSpacing * this->Longest);
}

// The sample at the middle of its arc.
int PieceList::middle(const Piece& piece) const
{
  const double half = 0.5 * (this->lengthTo(piece.from) + this->lengthTo(piece.to));
  int best = piece.from + 1;
  for (int i = best; i < piece.to; ++i)
  {
    best = std::abs(this->lengthTo(i) - half) < std::abs(this->lengthTo(best) - half) ? i : best;
  }
  return best;
}

// Sample between its ends that is farthest from the segment; the first of several.
PieceList::Farthest PieceList::farthest(const Piece& piece) const
{
  Farthest result;
  for (int i = piece.from + 1; i < piece.to; ++i)
  {
    const double distance =
      distanceToSegment(this->sample(i), this->sample(piece.from), this->sample(piece.to));
    if (result.sample < 0 || distance > result.distance)
    {
      result = { i, distance };
    }
  }
  return result;
}

void PieceList::split(int piece, int sample)
{
  const Piece second{ sample, this->Pieces[piece].to, this->Pieces[piece].halvings };
  this->Pieces[piece].to = sample;
  this->Pieces.insert(this->Pieces.begin() + piece + 1, second);
}

// Splits pieces begin to end - 1, and what comes of them, until they are near enough to their samples.
void PieceList::settle(int begin, int end)
{
  const double h = sampleSpacing * this->Longest;
  for (int i = begin; i < end;)
  {
    const Piece& piece = this->Pieces[i];
    const double limit = this->delta(piece);
    const double arc = this->lengthTo(piece.to) - this->lengthTo(piece.from);
    const bool shortArc = arc < 2.0 * h;
    const bool mayBeShort = this->halvingsOf(piece) > 0 && limit <= 0.3 * h;
    const Farthest most = this->farthest(piece);
    if (most.distance > limit && (!shortArc || mayBeShort))
    {
      this->split(i, most.sample);
      ++end;
    }
    else if (piece.to - piece.from > 1 && arc > this->longestArc(piece))
    {
      this->split(i, this->middle(piece));
      ++end;
    }
    else
    {
      ++i;
    }
  }
}

PieceList::Halved PieceList::halve(int piece)
{
  if (!(this->farthest(this->Pieces[piece]).distance > 1e-12 * this->Longest))
  {
    return Halved::Spent;
  }
  const std::size_t before = this->Pieces.size();
  ++this->Pieces[piece].halvings;
  this->settle(piece, piece + 1);
  return this->Pieces.size() > before ? Halved::Split : Halved::Same;
}

void PieceList::makeRoom(const Vector2& place, double share, double least)
{
  for (std::size_t i = 0; i < this->Pieces.size();)
  {
    const Piece& piece = this->Pieces[i];
    const Vector2 &from = this->sample(piece.from), &to = this->sample(piece.to);
    const double length = (to - from).norm();
    if (length > least && piece.to - piece.from > 1 && distanceToSegment(place, from, to) < share * length)
    {
      this->split(static_cast<int>(i), this->middle(piece));
      this->settle(static_cast<int>(i), static_cast<int>(i) + 2);
    }
    else
    {
      ++i;
    }
  }
}

void PieceList::divide()
{
  if (this->Pieces.size() == 1 && this->count() > 2)
  {
    this->split(0, this->count() / 2);
  }
}

bool PieceList::leavesOut(int piece, const Vector2& place) const
{
  bool inside = false;
  const Piece& p = this->Pieces[piece];
  for (int i = p.from; i < p.to; ++i)
  {
    inside ^= passesRight(place, this->sample(i), this->sample(i + 1));
  }
  return inside != passesRight(place, this->sample(p.to), this->sample(p.from));
}

std::vector<int> PieceList::vertices() const
{
  std::vector<int> result =
    mapped(this->Pieces, [this](const Piece& piece) { return piece.from % this->count(); });
  if (!this->Closed && !this->Pieces.empty())
  {
    result.push_back(this->Pieces.back().to);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace oversketch
