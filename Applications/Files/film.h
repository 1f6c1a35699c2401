// Films of a model that turns, as one file or numbered pictures; and pictures as PNG files.
#ifndef oversketch_applications_files_film_h
#define oversketch_applications_files_film_h

#include "files.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace oversketch_files
{

constexpr int framesOfTurn = 72, mostFramesOfTurn = 999; // the usual number, 3 seconds of film; the highest

// Files of a film of so many frames: the path itself of `.ogv` (Ogg Theora), NAME_001.png and so on of
// `.png`. Throws Failed for other extensions.
std::vector<std::string> filmFiles(const std::string& path, int frames);

// Makes a frame, of three bytes a pixel; frames are asked for once each and in their order. Null gives the
// film up.
using FrameMaker = std::function<vtkSmartPointer<vtkImageData>(int frame)>;
// Writes a film of 24 frames a second, all of one size; returns false where it was given up, and the files
// are not to be committed. Throws Failed.
bool writeFilm(const std::string& path, int frames, const FrameMaker& frame, NewFiles& files);

// Throws Failed.
void writePng(const std::string& path, vtkImageData* picture, NewFiles& files);

} // namespace oversketch_files
#endif
