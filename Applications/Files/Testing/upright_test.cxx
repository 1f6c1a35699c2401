// Pictures of every kind and orientation: upright, with their colours and their transparency.
#include "made_files.h"
#include "tiffs.h"
#include "upright_picture.h"

#include "files.h"
#include "texture.h"

#include "vtkBMPWriter.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkTIFFWriter.h"
#include "vtkUnsignedCharArray.h"

#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <unistd.h>

using namespace oversketch_files;
using oversketch_files_test::fileOf;
using namespace oversketch_test;

namespace
{

// As a picture is seen, row by row from the upper left, one letter a pixel.
using Seen = std::vector<std::string>;

const Seen stored = { "abc", "def" };
// By the sides of the screen that the file's first row and first column lie on.
const std::vector<Seen> upright = { { "abc", "def" },
  { "cba", "fed" },
  { "fed", "cba" },
  { "def", "abc" },
  { "ad", "be", "cf" },
  { "da", "eb", "fc" },
  { "fc", "eb", "da" },
  { "cf", "be", "ad" } };

// Each letter has a colour of its own, far from the others'.
std::array<int, 3> colourOf(char letter)
{
  const int k = letter - 'a';
  return { 250 - 40 * k, 30 * k + 20, k % 2 == 0 ? 200 : 30 };
}

// Each letter a square of so many pixels; with transparency b is half clear.
vtkSmartPointer<vtkImageData> imageOf(const Seen& seen, int side, int channels)
{
  const int width = side * static_cast<int>(seen[0].size()), height = side * static_cast<int>(seen.size());
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const char letter = seen[(height - 1 - y) / side][x / side];
      for (int k = 0; k < channels; ++k)
      {
        image->SetScalarComponentFromDouble(x,
          y,
          0,
          k,
          k < 3           ? colourOf(letter)[k]
          : letter == 'b' ? 128
                          : 255);
      }
    }
  }
  return image;
}

void expectSeen(const std::string& bytes, const Seen& seen, int side, int channels, double slack)
{
  const auto image = pictureOf(bytes);
  ASSERT_TRUE(image);
  const auto expected = imageOf(seen, side, channels);
  ASSERT_EQ(image->GetDimensions()[0], expected->GetDimensions()[0]);
  ASSERT_EQ(image->GetDimensions()[1], expected->GetDimensions()[1]);
  ASSERT_EQ(image->GetNumberOfScalarComponents(), channels);
  for (int y = side / 2; y < expected->GetDimensions()[1]; y += side) // the middles
  {
    for (int x = side / 2; x < expected->GetDimensions()[0]; x += side)
    {
      for (int k = 0; k < channels; ++k)
      {
        EXPECT_NEAR(image->GetScalarComponentAsDouble(x, y, 0, k),
          expected->GetScalarComponentAsDouble(x, y, 0, k),
          slack)
          << x << ", " << y << ", " << k;
      }
    }
  }
}

std::string webpOf(vtkImageData* image)
{
  GDALRegister_WEBP();
  GDALRegister_PNG();
  const std::string png = fileOf(image, vtkNew<vtkPNGWriter>().Get());
  VSIFCloseL(VSIFileFromMemBuffer(
    "/vsimem/a.png", reinterpret_cast<GByte*>(const_cast<char*>(png.data())), png.size(), FALSE));
  GDALDatasetH from = GDALOpen("/vsimem/a.png", GA_ReadOnly);
  const char* const options[] = { "LOSSLESS=YES", nullptr };
  GDALClose(
    GDALCreateCopy(GDALGetDriverByName("WEBP"), "/vsimem/a.webp", from, FALSE, options, nullptr, nullptr));
  GDALClose(from);
  vsi_l_offset size = 0;
  GByte* const bytes = VSIGetMemFileBuffer("/vsimem/a.webp", &size, TRUE);
  const std::string webp(reinterpret_cast<const char*>(bytes), size);
  VSIFree(bytes);
  VSIUnlink("/vsimem/a.png");
  return webp;
}

std::string bigEndian(std::uint32_t value)
{
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(value >> shift & 255);
  }
  return bytes;
}

// Exif data that says an orientation, in either order of bytes.
std::string exifOf(int orientation, bool isBig)
{
  const char said = static_cast<char>(orientation);
  return isBig
           ? std::string("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 19) + said + std::string(6, '\0')
           : std::string("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0", 18) + said + std::string(7, '\0');
}

std::string jpegWith(const std::string& jpeg, const std::string& exif)
{
  const std::size_t size = exif.size() + 8;
  return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(size >> 8) + static_cast<char>(size & 255) +
         std::string("Exif\0\0", 6) + exif + jpeg.substr(2);
}

std::string pngWith(const std::string& png, const std::string& exif)
{
  const std::string chunk = "eXIf" + exif;
  std::uint32_t sum = ~0U;
  for (const char byte : chunk)
  {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = sum >> 1 ^ (sum & 1U ? 0xedb88320U : 0U);
    }
  }
  const std::size_t behindHead = 8 + 25;
  return png.substr(0, behindHead) + bigEndian(static_cast<std::uint32_t>(exif.size())) + chunk +
         bigEndian(~sum) + png.substr(behindHead);
}

// An extended file: its head, the picture as it is, the Exif data.
std::string webpWith(const std::string& webp, const std::string& exif)
{
  // Exif data and transparency; 48 x 32 pixels, less one each.
  const std::string head = "VP8X" + bytesOf<std::uint32_t>({ 10, 0x18 }) + std::string("\x2f\0\0\x1f\0\0", 6);
  const std::string end = "EXIF" + bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(exif.size()) }) + exif;
  const std::string chunks = "WEBP" + head + webp.substr(12) + end;
  return "RIFF" + bytesOf<std::uint32_t>({ static_cast<std::uint32_t>(chunks.size()) }) + chunks;
}

} // namespace

TEST(UprightPicture, EveryOrientationOfEveryKindOfFile)
{
  const int side = 16; // of a square; 48 x 32 pixels are stored
  const auto colours = imageOf(stored, side, 3), clear = imageOf(stored, side, 4);
  const std::string jpeg = fileOf(colours, vtkNew<vtkJPEGWriter>().Get());
  const std::string png = fileOf(clear, vtkNew<vtkPNGWriter>().Get()), webp = webpOf(clear);
  std::string samples; // from the top
  for (int y = colours->GetDimensions()[1] - 1; y >= 0; --y)
  {
    samples.append(static_cast<const char*>(colours->GetScalarPointer(0, y, 0)), 3 * std::size_t(48));
  }
  for (int orientation = 1; orientation <= 8; ++orientation)
  {
    SCOPED_TRACE(orientation);
    const Seen& seen = upright[static_cast<std::size_t>(orientation - 1)];
    for (const bool isBig : { false, true })
    {
      const std::string exif = exifOf(orientation, isBig);
      const std::string made = uprightPicture(jpegWith(jpeg, exif));
      EXPECT_EQ(pictureFormatOf(made), "jpeg");
      EXPECT_EQ(orientationOf(made), 1);
      expectSeen(made, seen, side, 3, 6.0);
      expectSeen(uprightPicture(pngWith(png, exif)), seen, side, 4, 0.0);
      const std::string ofWebp = uprightPicture(webpWith(webp, exif));
      EXPECT_EQ(pictureFormatOf(ofWebp), "png");
      expectSeen(ofWebp, seen, side, 4, 0.0);
    }
    for (const bool isLarge : { false, true })
    {
      const std::string tiff = tiffOf(48,
        32,
        samples,
        { { 258, shorts({ 8, 8, 8 }) },
          { 262, shorts({ 2 }) },
          { 274, shorts({ static_cast<std::uint16_t>(orientation) }) },
          { 277, shorts({ 3 }) } },
        isLarge);
      EXPECT_EQ(orientationOf(tiff), orientation);
      expectSeen(uprightPicture(tiff), seen, side, 3, 0.0);
    }
  }
}

TEST(UprightPicture, WhatIsUprightStaysToTheByte)
{
  const auto colours = imageOf(stored, 16, 3);
  const std::string jpeg = fileOf(colours, vtkNew<vtkJPEGWriter>().Get());
  const std::string png = fileOf(colours, vtkNew<vtkPNGWriter>().Get());
  for (const std::string& bytes :
    { jpeg, png, jpegWith(jpeg, exifOf(1, true)), pngWith(png, exifOf(1, false)) })
  {
    EXPECT_TRUE(uprightPicture(bytes) == bytes);
  }
  // Orientations that make no sense count as upright: no ninth one, an offset beyond the end, data that
  // breaks off.
  EXPECT_EQ(orientationOf(jpegWith(jpeg, exifOf(9, true))), 1);
  std::string beyond = exifOf(6, false);
  beyond[7] = '\x7f';
  EXPECT_EQ(orientationOf(jpegWith(jpeg, beyond)), 1);
  EXPECT_EQ(orientationOf(jpegWith(jpeg, exifOf(6, true)).substr(0, 20)), 1);
  EXPECT_TRUE(uprightPicture("solid ball") == "solid ball");
}

TEST(UprightPicture, OtherKindsBecomePng)
{
  const auto colours = imageOf(stored, 2, 3), clear = imageOf(stored, 2, 4);
  const auto expectPng = [](const std::string& bytes, int channels)
  {
    const std::string made = uprightPicture(bytes);
    EXPECT_EQ(pictureFormatOf(made), "png");
    expectSeen(made, stored, 2, channels, 0.0);
  };
  expectPng(fileOf(colours, vtkNew<vtkBMPWriter>().Get()), 3);
  expectPng(fileOf(colours, vtkNew<vtkTIFFWriter>().Get()), 3); // rows from the bottom, and says so
  expectPng(fileOf(clear, vtkNew<vtkTIFFWriter>().Get()), 4);
  expectPng(webpOf(colours), 3);
  expectPng(webpOf(clear), 4);
}

TEST(UprightPicture, SamplesAreSeenAsTheFileSays)
{
  // Row by row from the upper left.
  const auto grays = [](const std::string& bytes)
  {
    std::vector<int> values;
    const auto image = pictureOf(uprightPicture(bytes));
    for (int k = 0; image && k < 4 * image->GetNumberOfScalarComponents(); ++k)
    {
      const int channels = image->GetNumberOfScalarComponents(), pixel = k / channels;
      values.push_back(
        static_cast<int>(image->GetScalarComponentAsDouble(pixel % 2, 1 - pixel / 2, 0, k % channels)));
    }
    return values;
  };
  using Values = std::vector<int>;
  const std::string four("\x00\x40\x80\xff", 4);
  EXPECT_EQ(grays(tiffOf(2, 2, four, {})), Values({ 0, 64, 128, 255 }));
  EXPECT_EQ(grays(tiffOf(2, 2, four, { { 262, shorts({ 0 }) } })),
    Values({ 255, 255, 255, 191, 191, 191, 127, 127, 127, 0, 0, 0 }))
    << "0 is white";
  EXPECT_EQ(
    grays(tiffOf(2, 2, bytesOf<std::uint16_t>({ 0, 257, 32896, 65535 }), { { 258, shorts({ 16 }) } })),
    Values({ 0, 1, 128, 255 }));
  EXPECT_EQ(grays(tiffOf(2, 2, "\x40\x80", { { 258, shorts({ 1 }) } })),
    Values({ 0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 0 }));
  // A palette: 0 is red, 1 green, 2 blue, the others black.
  std::vector<std::uint16_t> palette(768);
  palette[0] = palette[256 + 1] = palette[512 + 2] = 65535;
  EXPECT_EQ(
    grays(tiffOf(2, 2, std::string("\0\1\2\3", 4), { { 262, shorts({ 3 }) }, { 320, shorts(palette) } })),
    Values({ 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0 }));
  // Inks: cyan, magenta, yellow, black; none, cyan, yellow, black.
  EXPECT_EQ(grays(tiffOf(2,
              2,
              std::string("\0\0\0\0\xff\0\0\0\0\0\xff\0\0\0\0\xff", 16),
              { { 258, shorts({ 8, 8, 8, 8 }) }, { 262, shorts({ 5 }) }, { 277, shorts({ 4 }) } })),
    Values({ 255, 255, 255, 255, 0, 255, 255, 255, 255, 255, 0, 255, 0, 0, 0, 255 }));
  EXPECT_TRUE(uprightPicture(
    tiffOf(
      2, 2, bytesOf<float>({ 0.0F, 0.5F, 1.0F, 9.0F }), { { 258, shorts({ 32 }) }, { 339, shorts({ 3 }) } }))
                .empty())
    << "of real numbers";
}

TEST(UprightPicture, DamagedFilesAreRefusedAndNoneBreaksTheReader)
{
  const auto clear = imageOf(stored, 16, 4), colours = imageOf(stored, 16, 3);
  const std::string files[] = { webpWith(webpOf(clear), exifOf(6, false)),
    fileOf(colours, vtkNew<vtkBMPWriter>().Get()),
    fileOf(colours, vtkNew<vtkTIFFWriter>().Get()),
    pngWith(fileOf(clear, vtkNew<vtkPNGWriter>().Get()), exifOf(5, true)),
    jpegWith(fileOf(colours, vtkNew<vtkJPEGWriter>().Get()), exifOf(6, true)) };
  catchMessages();
  int refused = 0;
  for (const std::string& bytes : files)
  {
    for (std::size_t size = 4; size < bytes.size(); size += bytes.size() / 40 + 1)
    {
      refused += pictureOf(uprightPicture(bytes.substr(0, size))) ? 0 : 1;
      std::string spoilt = bytes;
      spoilt[size] = static_cast<char>(~spoilt[size]);
      const std::string made = uprightPicture(spoilt);
      EXPECT_TRUE(made.empty() || !pictureFormatOf(made).empty() || made == spoilt);
    }
  }
  EXPECT_GT(refused, 50);
  takeError();
}
