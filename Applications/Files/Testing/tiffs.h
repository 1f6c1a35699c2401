// TIFF files byte by byte, as other programs than ours write them.
#ifndef oversketch_applications_files_testing_tiffs_h
#define oversketch_applications_files_testing_tiffs_h

#include "made_files.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace oversketch_test
{

using oversketch_files_test::bytesOf;

struct TiffTag
{
  std::uint16_t type; // 2 text, 3 short, 4 long, 12 double
  std::uint64_t count;
  std::string bytes;
};

inline TiffTag shorts(const std::vector<std::uint16_t>& numbers)
{
  return { 3, numbers.size(), bytesOf(numbers) };
}
inline TiffTag doubles(const std::vector<double>& numbers)
{
  return { 12, numbers.size(), bytesOf(numbers) };
}
inline TiffTag text(const std::string& words)
{
  return { 2, words.size() + 1, words + '\0' };
}

// One strip of samples, with further tags; `large` for a BigTIFF.
inline std::string tiffOf(std::uint16_t width,
  std::uint16_t height,
  const std::string& samples,
  std::map<std::uint16_t, TiffTag> tags,
  bool large = false)
{
  const auto add = [&tags](std::uint16_t id, const TiffTag& tag) { tags.insert({ id, tag }); };
  add(256, shorts({ width }));
  add(257, shorts({ height }));
  add(258, shorts({ 8 }));
  add(259, shorts({ 1 }));
  add(262, shorts({ 1 }));
  add(277, shorts({ 1 }));
  add(278, shorts({ height }));
  add(273, { 4, 1, "" }); // where the strip is
  add(279, { 4, 1, bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(samples.size()) }) });
  const std::size_t room = large ? 8 : 4;
  const auto offset = [large](std::size_t at)
  {
    return large ? bytesOf<std::uint64_t>({ at })
                 : bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(at) });
  };
  const std::size_t head = large ? 16 : 8;
  const std::size_t after = head + (large ? 8 : 2) + tags.size() * (large ? 20 : 12) + room;
  std::string entries, values;
  tags[273].bytes = bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(after) }); // the samples come first
  for (const auto& [id, tag] : tags)
  {
    std::string value = tag.bytes;
    if (value.size() > room)
    {
      value = offset(after + samples.size() + values.size());
      values += tag.bytes;
    }
    value.resize(room, '\0');
    entries += bytesOf<std::uint16_t>({ id, tag.type }) + offset(tag.count) + value;
  }
  const std::string count = large ? bytesOf<std::uint64_t>({ tags.size() })
                                  : bytesOf<std::uint16_t>({ static_cast<std::uint16_t>(tags.size()) });
  return (large ? "II" + bytesOf<std::uint16_t>({ 43, 8, 0 }) : "II" + bytesOf<std::uint16_t>({ 42 })) +
         offset(head) + count + entries + offset(0) + samples + values;
}

} // namespace oversketch_test
#endif
