#include "png_picture.h"

#include "vtkOversketchFilterTools.h"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace oversketch_session
{
namespace
{

constexpr int stripRows = 128;  // in a strip
constexpr std::uint8_t sub = 1; // the filter: what a sample differs by from the same one a pixel before
constexpr int compression = 1, memory = 9;

void put32(std::string& bytes, std::uint32_t value)
{
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(value >> shift & 0xff);
  }
}

std::string chunk(const char* name, const std::string& data)
{
  std::string bytes;
  bytes.reserve(data.size() + 12);
  put32(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += name;
  bytes += data;
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data()) + 4;
  put32(bytes, static_cast<std::uint32_t>(crc32(0, from, static_cast<uInt>(data.size() + 4))));
  return bytes;
}

struct Strip
{
  std::string packed; // the chunk
  uLong sum = 1;      // Adler-32 of what is packed
  std::size_t size = 0;
  bool done = false;
};

// Packs rows from the top, begin to end; the first has the header of the stream.
void pack(const std::uint8_t* samples,
  std::size_t width,
  std::size_t colours,
  int height,
  int begin,
  Strip& strip)
{
  const int end = std::min(begin + stripRows, height);
  const std::size_t row = width * colours;
  std::vector<std::uint8_t> filtered((row + 1) * static_cast<std::size_t>(end - begin));
  std::uint8_t* to = filtered.data();
  for (int y = begin; y < end; ++y)
  {
    const std::uint8_t* from = samples + row * static_cast<std::size_t>(height - 1 - y);
    *to++ = sub;
    std::copy_n(from, colours, to);
    for (std::size_t i = colours; i < row; ++i)
    {
      to[i] = static_cast<std::uint8_t>(from[i] - from[i - colours]);
    }
    to += row;
  }
  const auto size = static_cast<uInt>(filtered.size());
  strip.size = size;
  strip.sum = adler32(1, filtered.data(), size);
  z_stream stream{};
  if (deflateInit2(&stream, compression, Z_DEFLATED, -MAX_WBITS, memory, Z_RLE) != Z_OK)
  {
    return;
  }
  std::string packed = begin == 0 ? std::string("\x78\x01", 2) : std::string();
  const std::size_t head = packed.size();
  packed.resize(head + deflateBound(&stream, size) + 16);
  stream.next_in = filtered.data();
  stream.avail_in = size;
  stream.next_out = reinterpret_cast<Bytef*>(&packed[head]);
  stream.avail_out = static_cast<uInt>(packed.size() - head);
  const int said = deflate(&stream, end == height ? Z_FINISH : Z_SYNC_FLUSH);
  strip.done = stream.avail_in == 0 && said == (end == height ? Z_STREAM_END : Z_OK);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  strip.packed = chunk("IDAT", packed);
}

} // namespace

std::string pngOf(const std::vector<std::uint8_t>& samples, int width, int height, int colours)
{
  std::vector<Strip> strips(static_cast<std::size_t>((height + stripRows - 1) / stripRows));
  oversketch::ThreadsOnly().parallelFor(static_cast<int>(strips.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        pack(samples.data(),
          static_cast<std::size_t>(width),
          static_cast<std::size_t>(colours),
          height,
          i * stripRows,
          strips[static_cast<std::size_t>(i)]);
      }
    });
  std::string header;
  put32(header, static_cast<std::uint32_t>(width));
  put32(header, static_cast<std::uint32_t>(height));
  header += std::string({ 8, static_cast<char>(colours == 1 ? 0 : 2), 0, 0, 0 });
  std::string bytes = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header);
  uLong sum = 1;
  for (const Strip& strip : strips)
  {
    if (!strip.done)
    {
      throw std::runtime_error("the picture cannot be written: zlib failed; is there memory left?");
    }
    bytes += strip.packed;
    sum = adler32_combine(sum, strip.sum, static_cast<z_off_t>(strip.size));
  }
  std::string end;
  put32(end, static_cast<std::uint32_t>(sum));
  return bytes + chunk("IDAT", end) + chunk("IEND", "");
}

} // namespace oversketch_session
