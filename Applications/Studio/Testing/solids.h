// Solids with edges, whose sides share their points.
#ifndef oversketch_applications_studio_testing_solids_h
#define oversketch_applications_studio_testing_solids_h

#include "Harness/shapes.h"

#include <array>
#include <map>

namespace oversketch_studio
{

// A box of n x n squares a side, two triangles each, from -1 to 1.
inline oversketch::Mesh boxOf(int n)
{
  oversketch::Mesh box;
  std::map<std::array<int, 3>, int> points;
  for (int side = 0; side < 6; ++side)
  {
    const bool out = side % 2 != 0;
    const auto point = [&](int i, int j)
    {
      std::array<int, 3> at{};
      at[side / 2] = out ? n : 0;
      at[(side / 2 + 1) % 3] = i;
      at[(side / 2 + 2) % 3] = j;
      const auto [it, isNew] = points.insert({ at, static_cast<int>(box.points.size()) });
      if (isNew)
      {
        box.points.emplace_back(2.0 * at[0] / n - 1.0, 2.0 * at[1] / n - 1.0, 2.0 * at[2] / n - 1.0);
      }
      return it->second;
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        const int a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
        box.triangles.push_back(out ? oversketch::Triangle{ a, b, c } : oversketch::Triangle{ a, c, b });
        box.triangles.push_back(out ? oversketch::Triangle{ a, c, d } : oversketch::Triangle{ a, d, c });
      }
    }
  }
  return box;
}

// A cylinder with its two ends closed, each by triangles about a point.
inline oversketch::Mesh drumOf(int around, int along)
{
  oversketch::Mesh drum = oversketch_test::cylinder(1.0, 2.0, around, along);
  for (const bool top : { false, true })
  {
    const auto middle = static_cast<int>(drum.points.size());
    drum.points.emplace_back(0.0, 0.0, top ? 2.0 : 0.0);
    for (int i = 0; i < around; ++i)
    {
      const int a = (top ? along * around : 0) + i, b = (top ? along * around : 0) + (i + 1) % around;
      drum.triangles.push_back(
        top ? oversketch::Triangle{ middle, a, b } : oversketch::Triangle{ middle, b, a });
    }
  }
  return drum;
}

} // namespace oversketch_studio
#endif
