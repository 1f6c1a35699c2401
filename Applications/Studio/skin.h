// What a mesh wears in the view: a picture, else its own colours, else none.
#ifndef oversketch_applications_studio_skin_h
#define oversketch_applications_studio_skin_h

#include "picture_files.h"

#include "vtkNew.h"

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

  // Shows the mesh so, with the bytes of its picture, if any; a plain one has the colour of setPlain. What it
  // wears is opaque, whatever is drawn.
  void dress(vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* mesh, const std::string& picture);
  void setPlain(vtkActor* actor, double red, double green, double blue);
  // Whether what it wears is seen; else its form alone.
  void setWorn(vtkActor* actor, bool worn);

private:
  void put(vtkActor* actor);

  vtkNew<vtkTexture> Texture;
  SharedPicture Picture; // of the texture; null: none
  bool Textured = false, Coloured = false, Worn = true;
  double Plain[3] = { 1.0, 1.0, 1.0 };
};

} // namespace oversketch_studio
#endif
