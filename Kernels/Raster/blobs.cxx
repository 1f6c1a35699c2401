#include "Raster/blobs.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace oversketch
{
namespace
{

struct RowRun
{
  int begin, end; // samples of a row
};

int rootOf(std::vector<int>& parents, int i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

} // namespace

Blobs blobsOf(const Frame& frame, const std::vector<std::uint8_t>& lines)
{
  std::vector<RowRun> runs;
  std::vector<int> offsets{ 0 }; // of the rows' runs
  std::vector<int> parents;
  for (int y = 0; y < frame.height; ++y)
  {
    const std::uint8_t* row = lines.data() + frame.index(0, y);
    const std::uint8_t* end = row + frame.width;
    for (const std::uint8_t* at = row; at != end;)
    {
      const std::uint8_t* begin = std::find(at, end, 0);
      at = std::find(begin, end, 1);
      if (begin != at)
      {
        parents.push_back(static_cast<int>(runs.size()));
        runs.push_back({ static_cast<int>(begin - row), static_cast<int>(at - row) });
      }
    }
    const int first = offsets.back();
    offsets.push_back(static_cast<int>(runs.size()));
    // Runs of this row and the last one that share a column are one area; its number is its first run's.
    for (int above = first, below = y > 0 ? offsets[y - 1] : first; above < offsets.back() && below < first;)
    {
      if (runs[above].begin < runs[below].end && runs[below].begin < runs[above].end)
      {
        const int a = rootOf(parents, above), b = rootOf(parents, below);
        parents[std::max(a, b)] = std::min(a, b);
      }
      runs[above].end < runs[below].end ? ++above : ++below;
    }
  }
  Blobs blobs;
  blobs.labels.assign(frame.count(), -1);
  std::vector<int> numbers(runs.size(), -1);
  for (int y = 0; y < frame.height; ++y)
  {
    for (int i = offsets[y]; i < offsets[y + 1]; ++i)
    {
      const int root = rootOf(parents, i);
      if (root == i)
      {
        numbers[i] = blobs.count();
        blobs.sizes.push_back(0);
      }
      numbers[i] = numbers[root];
      blobs.sizes[numbers[i]] += runs[i].end - runs[i].begin;
      std::fill(blobs.labels.begin() + frame.index(runs[i].begin, y),
        blobs.labels.begin() + frame.index(runs[i].end, y),
        numbers[i]);
    }
  }
  return blobs;
}

std::vector<Contact> contactsOf(const Frame& frame,
  const Blobs& blobs,
  const std::vector<Place>& pixels,
  std::vector<int>& stamps,
  int stamp)
{
  std::map<int, int> counts;
  for (const Place& p : pixels)
  {
    const std::size_t at = frame.index(p[0], p[1]);
    if (stamps[at] == stamp)
    {
      continue;
    }
    stamps[at] = stamp;
    const std::array<int, 4> beside{ blobs.labels[at - 1],
      blobs.labels[at + 1],
      blobs.labels[at - frame.width],
      blobs.labels[at + frame.width] };
    for (int i = 0; i < 4; ++i)
    {
      if (beside[i] >= 0 && std::find(beside.begin(), beside.begin() + i, beside[i]) == beside.begin() + i)
      {
        ++counts[beside[i]];
      }
    }
  }
  std::vector<Contact> contacts;
  contacts.reserve(counts.size());
  for (const auto& [blob, count] : counts)
  {
    contacts.push_back({ blob, count });
  }
  return contacts;
}

} // namespace oversketch
