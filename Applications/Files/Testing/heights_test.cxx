// Grids of heights from every kind of file: the same samples in the same places, or a refusal in words.
#include "heights.h"

#include "files.h"
#include "made_files.h"
#include "tiffs.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkTIFFWriter.h"
#include "vtkUnsignedShortArray.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <unistd.h>

using namespace oversketch_files;
using oversketch_files_test::fileOf;
using namespace oversketch_test;

namespace
{

double sample(vtkImageData* image, int i, int j)
{
  return image->GetPointData()->GetScalars()->GetComponent(j * image->GetDimensions()[0] + i, 0);
}

std::string refusalOf(const std::string& bytes)
{
  try
  {
    parseHeights("file", bytes);
  }
  catch (const Failed& failure)
  {
    return failure.what();
  }
  return "taken";
}

// 5 x 3 samples of 16 bits, 1000 i + 7 j from the lower left corner.
vtkSmartPointer<vtkImageData> ramp()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 3, 1);
  image->SetSpacing(2.0, 3.0, 1.0);
  vtkNew<vtkUnsignedShortArray> gray;
  gray->SetName("Gray");
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      gray->InsertNextValue(static_cast<unsigned short>(1000 * i + 7 * j));
    }
  }
  image->GetPointData()->SetScalars(gray);
  return image;
}

// 4 x 3 samples, 10 i + 100 j - 50 from the lower left, the third of the middle row a gap.
template <typename T>
std::string mapSamples(T gap)
{
  std::vector<T> samples;
  for (int j = 2; j >= 0; --j) // rows from the top
  {
    for (int i = 0; i < 4; ++i)
    {
      samples.push_back(i == 2 && j == 1 ? gap : static_cast<T>(10 * i + 100 * j - 50));
    }
  }
  return bytesOf(samples);
}

// Cells of 30 x 20; the upper left corner of the upper left one is at (500000, 4600000).
std::map<std::uint16_t, TiffTag> mapTags(std::uint16_t bits, std::uint16_t kind, const std::string& gap)
{
  return { { 258, shorts({ bits }) },
    { 339, shorts({ kind }) }, // 1 unsigned, 2 signed, 3 real
    { 33550, doubles({ 30.0, 20.0, 0.0 }) },
    { 33922, doubles({ 0.0, 0.0, 0.0, 500000.0, 4600000.0, 0.0 }) },
    { 42113, text(gap) } };
}

void expectMap(const std::string& bytes, const std::array<double, 2>& corner = { 500015.0, 4599950.0 })
{
  ASSERT_EQ(heightsFormatOf(bytes), "tif");
  const auto image = parseHeights("file", bytes);
  ASSERT_EQ(image->GetDimensions()[0], 4);
  ASSERT_EQ(image->GetDimensions()[1], 3);
  EXPECT_EQ(image->GetSpacing()[0], 30.0);
  EXPECT_EQ(image->GetSpacing()[1], 20.0);
  EXPECT_EQ(image->GetOrigin()[0], corner[0]);
  EXPECT_EQ(image->GetOrigin()[1], corner[1]);
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      const bool isGap = i == 2 && j == 1;
      EXPECT_TRUE(isGap ? std::isnan(sample(image, i, j)) : sample(image, i, j) == 10 * i + 100 * j - 50)
        << i << ", " << j << ": " << sample(image, i, j);
    }
  }
}

void expectRamp(const std::string& bytes, const char* format)
{
  SCOPED_TRACE(format);
  ASSERT_EQ(heightsFormatOf(bytes), format);
  const auto image = parseHeights("file", bytes);
  ASSERT_EQ(image->GetDimensions()[0], 5);
  ASSERT_EQ(image->GetDimensions()[1], 3);
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_EQ(sample(image, i, j), 1000.0 * i + 7.0 * j) << i << ", " << j;
    }
  }
}

} // namespace

TEST(Heights, SixteenBitsComeWholeAndFromTheBottom)
{
  expectRamp(fileOf(ramp(), vtkSmartPointer<vtkPNGWriter>::New().Get()), "png");
  expectRamp(fileOf(ramp(), vtkSmartPointer<vtkTIFFWriter>::New().Get()), "tif");
  std::string pgm = "P5\n# by hand\n5 3\n65535\n";
  std::string text = "P2 5 3 65535\n", grid = "NCOLS 5\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 2.5\n";
  for (int j = 2; j >= 0; --j)
  {
    for (int i = 0; i < 5; ++i)
    {
      const int value = 1000 * i + 7 * j;
      pgm += { static_cast<char>(value >> 8), static_cast<char>(value & 255) };
      text += std::to_string(value) + " ";
      grid += std::to_string(value) + (i < 4 ? " " : "\n");
    }
  }
  expectRamp(pgm, "pgm");
  expectRamp(text, "pgm");
  expectRamp(grid, "asc");
  EXPECT_DOUBLE_EQ(parseHeights("file", grid)->GetSpacing()[0], 2.5);
  for (int mode = 0; mode < 3; ++mode) // ascii, binary, appended
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetDataMode(mode);
    const std::string bytes = fileOf(ramp(), writer.Get());
    expectRamp(bytes, "vti");
    EXPECT_DOUBLE_EQ(parseHeights("file", bytes)->GetSpacing()[1], 3.0);
  }
}

TEST(Heights, MissingSamplesAreNoNumbers)
{
  const auto image = parseHeights("file", "ncols 2\nnrows 2\ncellsize 1\nNODATA_value -7\n1 -7\n3.5 -9999\n");
  EXPECT_TRUE(std::isnan(sample(image, 1, 1)));
  EXPECT_EQ(sample(image, 0, 1), 1.0);
  EXPECT_EQ(sample(image, 0, 0), 3.5);
  EXPECT_EQ(sample(image, 1, 0), -9999.0);
}

TEST(Heights, AGeoTiffLiesOnItsMap)
{
  const std::string shorted = mapSamples<std::int16_t>(-9999), real = mapSamples<float>(-9999.0F);
  expectMap(tiffOf(4, 3, shorted, mapTags(16, 2, "-9999")));
  expectMap(tiffOf(4, 3, real, mapTags(32, 3, "-9999")));
  expectMap(tiffOf(4, 3, real, mapTags(32, 3, "-9999"), true)); // BigTIFF
  expectMap(tiffOf(4, 3, mapSamples<double>(1e300), mapTags(64, 3, "1e300")));
  // As usually written, with fewer digits than the number has.
  const float lowest = std::numeric_limits<float>::lowest();
  expectMap(tiffOf(4, 3, mapSamples<float>(lowest), mapTags(32, 3, "-3.40282306074e+38")));
  expectMap(tiffOf(4, 3, mapSamples<float>(std::nanf("")), mapTags(32, 3, "nan")));
  // Samples at the places that the map names, not cells round them.
  auto points = mapTags(16, 2, "-9999");
  points[34735] = shorts({ 1, 1, 0, 1, 1025, 0, 1, 2 });
  expectMap(tiffOf(4, 3, shorted, points), { 500000.0, 4599960.0 });
  // Rows from the south: y grows with them.
  auto upward = mapTags(16, 2, "-9999");
  upward.erase(33550);
  upward.erase(33922);
  const auto affine = [](double column, double row, double turn) {
    return doubles({ column, turn, 0, 500000, turn, row, 0, 4600000, 0, 0, 0, 0, 0, 0, 0, 1 });
  };
  upward[34264] = affine(30, 20, 0);
  std::string turned; // rows
  for (std::size_t row = 3; row-- > 0;)
  {
    turned += shorted.substr(8 * row, 8);
  }
  expectMap(tiffOf(4, 3, turned, upward), { 500015.0, 4600010.0 });
  upward[34264] = affine(30, -20, 0);
  expectMap(tiffOf(4, 3, shorted, upward));
  upward[34264] = affine(30, -20, 5);
  EXPECT_NE(refusalOf(tiffOf(4, 3, shorted, upward)).find("turned or mirrored"), std::string::npos);
  upward[34264] = affine(-30, -20, 0);
  EXPECT_NE(refusalOf(tiffOf(4, 3, shorted, upward)).find("turned or mirrored"), std::string::npos);
}

TEST(Heights, AGeoTiffsScaleAndOffsetCount)
{
  auto tags = mapTags(16, 2, "-9999");
  tags[42112] = text("<GDALMetadata><Item name=\"OFFSET\" sample=\"0\" role=\"offset\">1000</Item>"
                     "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.25</Item></GDALMetadata>");
  const auto image = parseHeights("file", tiffOf(4, 3, mapSamples<std::int16_t>(-9999), tags));
  EXPECT_EQ(sample(image, 3, 2), 1000.0 + 0.25 * 180.0);
  EXPECT_TRUE(std::isnan(sample(image, 2, 1)));
}

TEST(Heights, OtherFormatsLieOnTheirMapsToo)
{
  const std::string grid = "1 2 3\n4 5 6\n";
  const auto corner =
    parseHeights("file", "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 4\n" + grid);
  EXPECT_EQ(corner->GetOrigin()[0], 102.0);
  EXPECT_EQ(corner->GetOrigin()[1], 202.0);
  const auto middle =
    parseHeights("file", "ncols 3\nnrows 2\nxllcenter 100\nyllcenter 200\ncellsize 4\n" + grid);
  EXPECT_EQ(middle->GetOrigin()[0], 100.0);
  EXPECT_EQ(middle->GetOrigin()[1], 200.0);
  EXPECT_EQ(parseHeights("file", "ncols 3\nnrows 2\n" + grid)->GetOrigin()[0], 0.0);
  const auto placed = ramp();
  placed->SetOrigin(7.0, 8.0, 0.0);
  vtkNew<vtkXMLImageDataWriter> writer;
  const auto vti = parseHeights("file", fileOf(placed, writer.Get()));
  EXPECT_EQ(vti->GetOrigin()[0], 7.0);
  EXPECT_EQ(vti->GetOrigin()[1], 8.0);
}

TEST(Heights, WhatIsDamagedIsRefusedInWords)
{
  const auto says = [](const std::string& bytes, const std::string& words)
  { EXPECT_NE(refusalOf(bytes).find(words), std::string::npos) << refusalOf(bytes); };
  says("", "no grid of heights");
  says("solid ball", ".asc");
  says("ncols 3\nnrows 2\n1 2 3 4", "breaks off in row 1");
  says("ncols 2\nnrows 1\n1 x", "'x' in row 0, column 1");
  says("ncols 2\n1 2", "without nrows");
  says("ncols two", "no number");
  says("ncols 16000\nnrows 16000\n1 2", "than it holds");
  says("ncols 2\nnrows 1\ncellsize 0\n1 2", "cellsize");
  says("P5 2 2 255\nabc", "fewer samples");
  says("P5 2 2 70000\nabcdefgh", "range");
  says("P2 1 2 9\n3 12", "range");
  says("P5 2", "breaks off");
  for (const std::string& bytes : { fileOf(ramp(), vtkSmartPointer<vtkPNGWriter>::New().Get()),
         fileOf(ramp(), vtkSmartPointer<vtkTIFFWriter>::New().Get()) })
  {
    for (std::size_t size = 8; size + 12 < bytes.size(); size += 5)
    {
      const std::string said = refusalOf(bytes.substr(0, size));
      EXPECT_TRUE(said == "taken" || said.find("file: ") == 0) << said;
    }
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetDataModeToAscii();
  std::string vti = fileOf(ramp(), writer.Get());
  const auto with = [&vti](const std::string& old, const std::string& other)
  {
    std::string text = vti;
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + other.size()))
    {
      text.replace(at, old.size(), other);
    }
    return text;
  };
  says(with("0 4 0 2 0 0", "0 4 0 2 0 3"), "several slices");
  says(with("0 4 0 2 0 0", "0 4 0 3 0 0"), "breaks off");
  says(with("0 4 0 2 0 0", "0 4 2 0 0 0"), "no samples");
  says(with("0 4 0 2 0 0", "0 16000 0 16000 0 0"), "than a file of its size");
  says(with("ImageData", "PolyData"), "is not an XML ImageData file");
  says(vti.substr(0, vti.size() / 2), "no XML from line");
}
