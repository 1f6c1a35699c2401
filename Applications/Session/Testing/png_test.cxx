// Pictures written as PNG are read as they were.
#include "png_picture.h"
#include "texture.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch_session;

TEST(PngPicture, IsReadAsItWas)
{
  std::mt19937 random(3);
  for (const int height : { 1, 127, 128, 129, 700 })
  {
    for (const int width : { 1, 3, 250 })
    {
      for (const int colours : { 1, 3 })
      {
        std::vector<std::uint8_t> samples(static_cast<std::size_t>(width * height * colours), 200);
        std::generate(samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2),
          samples.end(),
          [&] { return static_cast<std::uint8_t>(random()); });
        const auto read = oversketch_files::pictureOf(pngOf(samples, width, height, colours));
        ASSERT_TRUE(read) << width << " x " << height << " of " << colours;
        ASSERT_EQ(read->GetDimensions()[0], width);
        ASSERT_EQ(read->GetDimensions()[1], height);
        ASSERT_EQ(read->GetNumberOfScalarComponents(), colours);
        const auto* from = static_cast<const std::uint8_t*>(read->GetScalarPointer());
        ASSERT_TRUE(std::equal(samples.begin(), samples.end(), from)) << width << " x " << height;
      }
    }
  }
}
