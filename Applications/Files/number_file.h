// A file of numbers: words, or bytes of VTK's types.
#ifndef oversketch_applications_files_number_file_h
#define oversketch_applications_files_number_file_h

#include "text.h"

#include "vtkDataArray.h"

#include <cstring>

namespace oversketch_files
{

template <typename T>
double loadedAs(const char* at)
{
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

// A number of VTK's type, which must lie there whole.
inline double numberAt(const char* at, int type, bool bigEndian = false)
{
  char bytes[8] = {};
  const int size = std::min(vtkDataArray::GetDataTypeSize(type), 8);
  std::copy_n(at, size, bytes);
  if (bigEndian)
  {
    std::reverse(bytes, bytes + size);
  }
  switch (type)
  {
    vtkTemplateMacro(return loadedAs<VTK_TT>(bytes));
  }
  return 0.0;
}

// Reads them one after the other.
class NumberFile
{
public:
  explicit NumberFile(const std::string& path)
    : Path(path)
    , Bytes(wholeFile(path))
  {
  }

  [[noreturn]] void refuse(const std::string& why) const { throw Failed(this->Path + ": " + why); }

  // The next one, of VTK's type where it is bytes.
  double number(int type)
  {
    if (this->Binary)
    {
      const auto size = static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type));
      if (this->Bytes.size() - this->At < size)
      {
        this->refuseEnd();
      }
      this->At += size;
      return numberAt(this->Bytes.data() + this->At - size, type, this->BigEndian);
    }
    Words words(this->Bytes, this->At);
    const std::string_view word = words.next();
    this->At = words.at();
    const std::optional<double> value = numberOf(word);
    if (word.empty())
    {
      this->refuseEnd();
    }
    if (!value)
    {
      this->refuse("holds " + inQuotes(word) + " where a number should be; the file is damaged");
    }
    return *value;
  }

protected:
  [[noreturn]] void refuseEnd() const
  {
    this->refuse("ends before all that its header announces; the file is truncated or damaged");
  }

  std::string Path, Bytes;
  std::size_t At = 0;
  bool Binary = false, BigEndian = false;
};

} // namespace oversketch_files
#endif
