// The model in the view. Parts of it that wear pictures of their own are drawn each by itself.
#ifndef oversketch_applications_studio_view_model_view_h
#define oversketch_applications_studio_view_model_view_h

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <set>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

// How a surface is drawn.
enum class Shading
{
  Smooth,
  Flat,  // each face by itself
  Wire,  // smooth, and its edges
  Matcap // as a ball of clay is lit, without what the model wears; shows dents and creases
};
constexpr int shadings = 4;

// What a surface that is not clay is lit by. No light makes a white surface whiter than white.
enum class Light
{
  Three, // key, fill and rim
  Head,  // one at the eye
  Matcap // as a ball of plaster is lit: by the way the surface faces, seen from the eye, alone
};
constexpr int lights = 3;

// How a model is seen.
struct ModelLook
{
  Shading shading = Shading::Smooth;
  Light light = Light::Three;
  bool pictures = true;                         // and colours that it wears are seen
  std::array<double, 3> plain{ 1.0, 1.0, 1.0 }; // the colour of what wears nothing
};

class ModelView
{
public:
  explicit ModelView(vtkRenderer* renderer);
  ~ModelView();

  // Shows a mesh in what it wears, instead of the last, where it is not the same; shows none.
  void show(vtkPolyData* mesh);
  void clear();
  // Shows the same mesh moved, in the same skins.
  void preview(vtkPolyData* mesh);
  vtkPolyData* mesh() const { return this->Shown; } // null where none is shown
  // What is drawn of it; nothing where it is not visible.
  std::vector<vtkPolyData*> drawn() const;
  // That without the parts that are hidden.
  vtkSmartPointer<vtkPolyData> seen() const { return this->Shown ? this->seen(this->Shown) : nullptr; }
  bool owns(const vtkActor* actor) const;

  void setLook(const ModelLook& look);
  void setVisible(bool visible);
  // Draws no faces that others hide, where that can be told, or all.
  void hideBacks(bool hide);
  // Makes a coarser skin for the hand's movements, of a large mesh (CoarseSkin), once for its faces.
  void makeCoarse();
  // Draws that from here on, where there is one, or the mesh itself. Returns whether it does.
  bool drawCoarse(bool coarse);
  // These parts of it (cell array PartId) are not drawn; of a mesh without parts, -1: all of it.
  void hide(const std::set<int>& parts);

private:
  struct Part;
  void resize(std::size_t count);

  vtkSmartPointer<vtkPolyData> seen(vtkPolyData* mesh) const;

  vtkRenderer* Renderer; // outlives it
  std::set<int> Hidden;
  std::vector<std::unique_ptr<Part>> Parts;
  vtkSmartPointer<vtkPolyData> Shown;
  vtkSmartPointer<vtkPolyData> Dressed; // that one, until it is moved
  ModelLook Look;
  bool Visible = true;
};

} // namespace oversketch_studio
#endif
