// What a mesh wears in the view: a picture, else its own colours, else none.
#ifndef oversketch_applications_studio_view_skin_h
#define oversketch_applications_studio_view_skin_h

#include "picture_files.h"

#include "vtkNew.h"

#include <QObject>

#include <array>
#include <functional>
#include <memory>
#include <string>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkTexture;

namespace oversketch_studio
{

class Skin
{
public:
  Skin();
  ~Skin();
  Skin(const Skin&) = delete;
  Skin& operator=(const Skin&) = delete;

  // Shows the mesh so, with the bytes of its picture, if any; a plain one has the colour of setLook. What it
  // wears is opaque, whatever is drawn. A picture that nobody has decoded yet comes later; then it calls
  // `comes`.
  void dress(vtkActor* actor,
    vtkPolyDataMapper* mapper,
    vtkPolyData* mesh,
    const std::string& picture,
    const std::function<void()>& comes);
  // Whether what it wears is seen; else its form alone.
  void setLook(vtkActor* actor, const std::array<double, 3>& plain, bool worn);

private:
  void put(vtkActor* actor);
  void wear(const SharedPicture& picture);

  vtkNew<vtkTexture> Texture;
  SharedPicture Picture;          // of the texture; null: none
  PictureBytes Wanted;            // of the picture that is to come, or has come
  std::unique_ptr<QObject> Waits; // for it
  bool Textured = false, Coloured = false, Worn = true;
  std::array<double, 3> Plain{ 1.0, 1.0, 1.0 };
};

} // namespace oversketch_studio
#endif
