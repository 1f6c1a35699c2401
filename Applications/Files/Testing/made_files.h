// Files that tests make: they go with the test, and a glTF document around four points.
#ifndef oversketch_applications_files_testing_made_files_h
#define oversketch_applications_files_testing_made_files_h

#include "mesh_file.h"

#include "vtkBase64Utilities.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace oversketch_files_test
{

// A file that goes with the test.
class Written
{
public:
  Written(const std::string& name, const std::string& bytes)
    : Path(std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-" + name))
  {
    std::ofstream(this->Path, std::ios::binary) << bytes;
  }
  ~Written() { std::filesystem::remove(this->Path); }
  std::string path() const { return this->Path.string(); }

private:
  std::filesystem::path Path;
};

template <typename T>
std::string bytesOf(const std::vector<T>& values)
{
  return { reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T) };
}

inline std::string dataUri(const std::string& bytes)
{
  std::string code(2 * bytes.size() + 8, ' ');
  code.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
    bytes.size(),
    reinterpret_cast<unsigned char*>(code.data())));
  return "data:application/octet-stream;base64," + code;
}

// A glTF around four points (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), four normals along z, and more bytes
// behind them, from 96 on, which is view 2. The accessors 0 and 1 are points and normals; "rest" is the
// document's other members.
inline std::string gltf(const std::string& rest,
  const std::string& more = "",
  const std::string& accessors = "")
{
  const std::string data = bytesOf<float>({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }) +
                           bytesOf<float>({ 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 }) + more;
  return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(data.size()) +
         R"(,"uri":")" + dataUri(data) +
         R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":48},)" +
         R"({"buffer":0,"byteOffset":96,"byteLength":)" + std::to_string(data.size() - 96) +
         R"(}],"accessors":[)" + R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)" +
         R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":4})" + accessors + "]," + rest + "}";
}

inline vtkSmartPointer<vtkPolyData> readText(const std::string& text,
  const std::string& name,
  oversketch_files::Notes& notes)
{
  return oversketch_files::readMesh(Written(name, text).path(), notes);
}

inline vtkSmartPointer<vtkPolyData> readText(const std::string& text, const std::string& name = "made.gltf")
{
  oversketch_files::Notes notes;
  return readText(text, name, notes);
}

inline bool isSaid(const oversketch_files::Notes& notes, const std::string& words)
{
  for (const std::string& note : notes)
  {
    if (note.find(words) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

inline std::string allOf(const oversketch_files::Notes& notes)
{
  std::string text;
  for (const std::string& note : notes)
  {
    text += note + '\n';
  }
  return text;
}

// The bytes of the file that a writer of VTK makes of an image.
template <typename Writer>
std::string fileOf(vtkImageData* image, Writer* writer)
{
  const Written file("made", "");
  writer->SetInputData(image);
  writer->SetFileName(file.path().c_str());
  writer->Write();
  return oversketch_files::wholeFile(file.path());
}

// The bytes of a picture of one grey.
template <typename Writer = vtkPNGWriter>
std::string pictureOfGrey(unsigned char grey, int side = 2)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), side * side, grey);
  return fileOf(image, vtkNew<Writer>().Get());
}

inline std::vector<double> tuple(vtkDataArray* array, vtkIdType at)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(at, values.data());
  return values;
}

using Numbers = std::vector<double>;

} // namespace oversketch_files_test
#endif
