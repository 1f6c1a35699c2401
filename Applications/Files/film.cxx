#include "film.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <array>

namespace oversketch_files
{

namespace
{

constexpr const char* ogg = ".ogv";
constexpr int frameRate = 24; // a second
constexpr int bestQuality = 2;
constexpr std::size_t leastDigits = 3;

// Closes the file, also where a frame could not be made.
struct Ended
{
  vtkOggTheoraWriter* writer;
  ~Ended() { this->writer->End(); }
};

[[noreturn]] void failFilm(const std::string& path)
{
  throw Failed(path + ": could not be written (is the disk full?)");
}

// Of the size of the first frame: a window may have been resized meanwhile.
vtkSmartPointer<vtkImageData> nextFrame(const std::string& path,
  int number,
  const FrameMaker& frame,
  std::array<int, 3>& size)
{
  vtkSmartPointer<vtkImageData> made = frame(number);
  if (made)
  {
    std::array<int, 3> its{};
    made->GetDimensions(its.data());
    size = number == 0 ? its : size;
    if (its != size)
    {
      throw Failed(
        path + ": the view has another size than when the film began; leave its size as it is and try again");
    }
  }
  return made;
}

} // namespace

std::vector<std::string> filmFiles(const std::string& path, int frames)
{
  const std::string extension = extensionOf(path);
  if (extension == ogg)
  {
    return { path };
  }
  if (extension != ".png")
  {
    throw Failed(path + ": no format of films; the name ends in one of " + filmExtensions);
  }
  const std::string stem = path.substr(0, path.size() - extension.size());
  std::vector<std::string> paths;
  for (int i = 1; i <= frames; ++i)
  {
    const std::string number = std::to_string(i);
    paths.push_back(stem + '_' + std::string(leastDigits - std::min(leastDigits, number.size()), '0') +
                    number + path.substr(stem.size()));
  }
  return paths;
}

bool writeFilm(const std::string& path, int frames, const FrameMaker& frame, NewFiles& files)
{
  const std::vector<std::string> paths = filmFiles(path, frames);
  std::array<int, 3> size{};
  vtkSmartPointer<vtkImageData> made = nextFrame(path, 0, frame, size);
  int done = 0;
  const auto next = [&] { made = ++done < frames ? nextFrame(path, done, frame, size) : nullptr; };
  if (extensionOf(path) != ogg)
  {
    for (; made; next())
    {
      writePng(paths[static_cast<std::size_t>(done)], made, files);
    }
    return done == frames;
  }
  if (!made)
  {
    return false;
  }
  files.write(path,
    [&](const std::string& temporary)
    {
      vtkNew<vtkOggTheoraWriter> writer;
      writer->SetFileName(temporary.c_str());
      writer->SetRate(frameRate);
      writer->SetQuality(bestQuality);
      writer->Start();
      {
        const Ended ended{ writer };
        for (; made && writer->GetError() == 0; next())
        {
          writer->SetInputData(made);
          writer->Write();
        }
      }
      if (writer->GetError() != 0)
      {
        failFilm(path);
      }
    });
  return done == frames;
}

void writePng(const std::string& path, vtkImageData* picture, NewFiles& files)
{
  files.write(path,
    [&](const std::string& temporary)
    {
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputData(picture);
      writer->SetFileName(temporary.c_str());
      writer->Write();
      if (writer->GetErrorCode() != vtkErrorCode::NoError)
      {
        failFilm(path);
      }
    });
}

} // namespace oversketch_files
