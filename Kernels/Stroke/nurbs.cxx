#include "Stroke/nurbs.h"

#include "Mesh/context.h"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace oversketch
{

Nurbs::Nurbs(int count, bool closed)
  : Count(count)
  , Degree(std::min(3, count - 1))
  , Closed(closed)
{
  if (count < (closed ? 3 : 2))
  {
    throw Error(Failure::BadStroke,
      "%1 curve needs %2 points, not %3; draw a longer one.",
      closed ? "A closed" : "An open",
      (closed ? "3" : "2"),
      count);
  }
}

SplinePlace Nurbs::at(double t) const
{
  // In units of the pieces' length; a closed curve's pieces of even degree begin half a unit early.
  const int pieces = this->Closed ? this->Count : this->Count - this->Degree;
  const double shift = this->Closed && this->Degree % 2 == 0 ? 0.5 : 0.0;
  const double x = std::clamp(t, 0.0, 1.0) * pieces + shift;
  const int piece =
    this->Closed ? static_cast<int>(std::floor(x)) : std::min(static_cast<int>(x), pieces - 1);
  const auto knot = [&](int i) { return static_cast<double>(this->Closed ? i : std::clamp(i, 0, pieces)); };

  // Cox's and de Boor's recurrence: the functions that are not zero on the piece.
  SplinePlace place;
  place.count = this->Degree + 1;
  place.weights[0] = 1.0;
  for (int d = 1; d <= this->Degree; ++d)
  {
    double carried = 0.0;
    for (int r = 0; r < d; ++r)
    {
      const double left = knot(piece + 1 + r - d), right = knot(piece + 1 + r);
      const double share = place.weights[r] / (right - left);
      place.weights[r] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    place.weights[d] = carried;
  }
  for (int i = 0; i <= this->Degree; ++i)
  {
    const int first = this->Closed ? piece - this->Degree / 2 : piece;
    place.points[i] = this->Closed ? (first + i + 2 * this->Count) % this->Count : first + i;
  }
  return place;
}

double Nurbs::parameterOf(int i) const
{
  if (this->Closed)
  {
    return static_cast<double>(i) / this->Count;
  }
  const int pieces = this->Count - this->Degree;
  double sum = 0.0;
  for (int k = 1; k <= this->Degree; ++k)
  {
    sum += std::clamp(i + k - this->Degree, 0, pieces);
  }
  return sum / (this->Degree * pieces);
}

Eigen::MatrixXd Nurbs::interpolating(const Eigen::MatrixXd& values) const
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < this->Count; ++i)
  {
    const SplinePlace place = this->at(this->parameterOf(i));
    for (int k = 0; k < place.count; ++k)
    {
      entries.emplace_back(i, place.points[k], place.weights[k]);
    }
  }
  Eigen::SparseMatrix<double> matrix(this->Count, this->Count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
  return factor.solve(values); // such a matrix has an inverse, for any count
}

} // namespace oversketch
