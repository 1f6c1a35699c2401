#include "film.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"
#include "vtkPNGWriter.h"

#include <algorithm>

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
    throw Failed(path + ": no format of films; end the name in .ogv or .png");
  }
  const std::size_t stem = path.size() - extension.size();
  std::vector<std::string> paths;
  for (int i = 1; i <= frames; ++i)
  {
    const std::string number = std::to_string(i);
    const std::string zeros(leastDigits - std::min(leastDigits, number.size()), '0');
    paths.push_back(path.substr(0, stem) + '_' + zeros + number + path.substr(stem));
  }
  return paths;
}

bool writeFilm(const std::string& path, int frames, const FrameMaker& frame, NewFiles& files)
{
  const std::vector<std::string> paths = filmFiles(path, frames);
  int done = 0;
  vtkSmartPointer<vtkImageData> made = frame(0);
  const auto next = [&] { made = ++done < frames ? frame(done) : nullptr; };
  for (; made && extensionOf(path) != ogg; next())
  {
    writePng(paths[static_cast<std::size_t>(done)], made, files);
  }
  if (!made)
  {
    return done == frames;
  }
  files.write(path,
    [&](const std::string& temporary)
    {
      vtkNew<vtkOggTheoraWriter> writer;
      writer->SetFileName(temporary.c_str());
      writer->SetRate(frameRate);
      writer->SetQuality(bestQuality);
      writer->SetInputData(made);
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
        throw Failed(
          path + ": could not be written (is the disk full, or was the view made larger or smaller?)");
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
        throw Failed(path + ": could not be written (is the disk full?)");
      }
    });
}

} // namespace oversketch_files
