/**
 * @class vtkOversketchInflateDrawing
 * @brief a drawing, and the picture under it, becomes a model
 *
 * Source: "Image-Assisted Modeling from Sketches": outlines and features drawn on a canvas are classified, a
 * planar mesh is made whose edges lie on them, and it is inflated to both sides or extruded, with holes and
 * tunnels, and wears the picture. The whole is this one filter over those of the steps, in their order:
 * Trace, Canvas, MagneticSnap, Resample, Arrange, Classify, Treatment, Distance, Polyline, Darts, CoarseMesh,
 * QuadMerge, Refine, Inflate or Extrude, Tunnel, ProjectTexture, and of layers Layers (GetStage, GetStep,
 * GetInnerOutput). Each departs from the paper as its header says; AsPublished turns the departures off.
 *
 * Refinement that would turn triangles over, or miss small tips, hands parts of strokes back to be followed
 * more closely ({Refine}, output 2): steps Polyline to Refine then run again, at most 24 times, until it
 * hands back none.
 *
 * Layers are ours. A closed stroke with another Depth than 0 bounds one, as does, in the plane itself, an
 * outline with Height or CrossSection. Another stroke is of the last layer before it that it lies wholly in,
 * or of one in the plane, else of the plane. Each layer is made by a system of its own. One in front is moved
 * along z: its middle plane lies at the mean height, over its area, of what is seen from the front of the
 * bodies before it, in the order of strokes; one behind likewise from behind. The first body stays in the
 * plane, and, with a warning, one that lies over nothing. Cell arrays of strokes, which may be absent:
 * - Depth, int: 0 in the plane (default), 1 in front, 2 behind, 3 both; not read of open strokes,
 * - Height, double: factor of heights and extrusion beside the drawing's; 0 (default): 1,
 * - CrossSection, int: 0 the drawing's (default), 1 circle, 2 linear, 3 step; these go before Poisson.
 *
 * Input 0 (Strokes, optional): stroke polydata: polylines in display coordinates, each with its view, drawn
 * over the plane z = 0; see vtkOversketchCanvas for what else they may say, and oversketch.drawing in Python.
 * Without Trace it must be there.
 * Input 1 (Picture, optional, vtkImageData): the picture that was drawn over. It gives the canvas, edges to
 * magnetic strokes, and texture coordinates their meaning.
 * Input 2 (BackPicture, optional, vtkImageData): a picture of the back, as seen from behind, which faces of
 * the back are to wear: see vtkOversketchProjectTexture, which gives them points of their own then.
 *
 * Output 0: the model, a closed mesh but for tunnels without walls: triangles, or with Quads quads. Arrays of
 * vtkOversketchInflate or vtkOversketchExtrude, and TCoords; field array Canvas. With layers all
 * bodies, and cell array LayerId, int: 0 of the plane, else the layer's number, from 1 in the order of
 * strokes; StrokeId is then the stroke's number, RegionId and ObjectId count in each layer. The picture
 * itself is not in it: give a renderer the picture as a texture; the command and sessions put what it wears
 * of it beside the mesh.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): those of the steps, as theirs; BadStroke where
 * there are neither strokes nor Trace, for a Trace that is no list of places or has no picture, where no
 * stroke bounds an object, or a stroke still turns triangles over after 24 rebuilds, named with the place.
 * Strokes without points give an empty output silently, where nothing is traced. Strokes that are rejected
 * are said in warnings.
 *
 * Deterministic: same result bit for bit for any number of threads, whatever was drawn before. What the steps
 * computed is kept by what they read: a further feature measures no distance anew, another profile makes no
 * mesh, another height solves nothing.
 *
 * @sa vtkOversketchCanvas vtkOversketchInflate vtkOversketchAssemble
 */
#ifndef vtkOversketchInflateDrawing_h
#define vtkOversketchInflateDrawing_h

#include "OversketchFiltersInflateDrawingModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include <memory>
#include <string>

class OVERSKETCHFILTERSINFLATEDRAWING_EXPORT vtkOversketchInflateDrawing : public vtkOversketchSystem
{
public:
  static vtkOversketchInflateDrawing* New();
  vtkTypeMacro(vtkOversketchInflateDrawing, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Extrudes so far to either side in place of inflating [world, from 0, default 0: inflates].
   */
  void SetExtrudeDepth(double depth);
  vtkGetMacro(ExtrudeDepth, double);
  ///@}

  ///@{
  /**
   * The cross-section of what is inflated: empty (default) or "circle", "linear", "step", or a polyline "x y,
   * x y, …" from rim to ridge; see vtkOversketchInflate.
   */
  void SetProfile(const char* text);
  const char* GetProfile() const { return this->Profile.c_str(); }
  ///@}

  ///@{
  /**
   * Heights are multiplied by this [default 1].
   */
  void SetHeight(double factor);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Inflate by the solution of a Poisson equation in place of the distance: rounder, thin limbs thicker
   * [default off].
   */
  void SetPoisson(bool poisson);
  vtkGetMacro(Poisson, bool);
  vtkBooleanMacro(Poisson, bool);
  ///@}

  ///@{
  /**
   * Numbers of strokes, from 0 in the drawing's order, whose inside is cut out before the surface is made:
   * "2" or "2 5" [default none]. They go before a stroke's own Treatment.
   */
  void SetHoles(const char* strokes);
  const char* GetHoles() const { return this->Holes.c_str(); }
  ///@}

  ///@{
  /**
   * Numbers of strokes, written alike, whose inside is cut out of the finished surface.
   */
  void SetTunnels(const char* strokes);
  const char* GetTunnels() const { return this->Tunnels.c_str(); }
  ///@}

  ///@{
  /**
   * Numbers of closed strokes, written alike, that bound layers in front. This list and the next two add up
   * and go before a stroke's own Depth.
   */
  void SetInFront(const char* strokes);
  const char* GetInFront() const { return this->InFront.c_str(); }
  ///@}

  ///@{
  /**
   * Numbers of those that bound layers behind.
   */
  void SetBehind(const char* strokes);
  const char* GetBehind() const { return this->Behind.c_str(); }
  ///@}

  ///@{
  /**
   * Numbers of those that bound layers on both sides.
   */
  void SetBothSides(const char* strokes);
  const char* GetBothSides() const { return this->BothSides.c_str(); }
  ///@}

  ///@{
  /**
   * Places of the picture at which vtkOversketchTrace finds outlines: "auto", which is its largest thing, or
   * "x y" in px from its lower left corner, y up; several apart by commas, semicolons or spaces [default
   * none]. The outlines come before the strokes, and are numbered so.
   */
  void SetTrace(const char* places);
  const char* GetTrace() const { return this->Trace.c_str(); }
  ///@}

  ///@{
  /**
   * Moves every stroke to the picture's edges beside it; off (default), those whose Magnetic says so.
   */
  void SetMagnetic(bool magnetic);
  vtkGetMacro(Magnetic, bool);
  vtkBooleanMacro(Magnetic, bool);
  ///@}

  ///@{
  /**
   * Merge triangles to quads and refine by Catmull and Clark's scheme in place of Loop's [default off].
   */
  void SetQuads(bool quads);
  vtkGetMacro(Quads, bool);
  vtkBooleanMacro(Quads, bool);
  ///@}

  ///@{
  /**
   * How often the coarse mesh is refined [0 to 10, default 3]; where its faces are large, once more, if not
   * 0 and not as published, see vtkOversketchPlanarRefine's LargeFacesOnceMore.
   */
  void SetLevels(int levels);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Strokes may cross each other and themselves, span what they lie in, and bound an object together
   * (vtkOversketchArrange) [default off: a stroke that meets another one is an error; not as published].
   */
  void SetArrange(bool arrange);
  vtkGetMacro(Arrange, bool);
  vtkBooleanMacro(Arrange, bool);
  ///@}

  ///@{
  /**
   * Turn every departure of every step off (true) or on (false, default): sets the properties of the inner
   * steps at once, so single ones can be changed afterwards by GetStep.
   */
  void SetAsPublished(bool published);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * The system that makes a layer, by its number in LayerId, for outputs and counters of its steps; null for
   * 0 and where there is none. It is set up in each run: set nothing there.
   */
  vtkOversketchInflateDrawing* GetLayer(int layer);

  ///@{
  /**
   * How often the last run made meshes anew, see above, and how often it refined one at most; 0 after one
   * that failed.
   */
  vtkGetMacro(Rebuilds, int);
  vtkGetMacro(LevelsMade, int);
  ///@}

  /**
   * Classes that strokes were taken for, strokes, as words, those of layers after the plane's; and the two
   * above, rebuilds and levels.
   */
  FigureList Figures() override;

protected:
  vtkOversketchInflateDrawing();
  ~vtkOversketchInflateDrawing() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  oversketch::Message Said(const oversketch::Message& message) override;

private:
  vtkOversketchInflateDrawing(const vtkOversketchInflateDrawing&) = delete;
  void operator=(const vtkOversketchInflateDrawing&) = delete;

  double ExtrudeDepth = 0.0;
  double Height = 1.0;
  bool Poisson = false;
  bool Magnetic = false;
  bool Quads = false;
  bool AsPublished = false;
  bool Arrange = false;
  int Levels = 3;
  int Rebuilds = 0, LevelsMade = 0;
  std::string Profile, Holes, Tunnels, InFront, Behind, BothSides, Trace;

  struct Pipeline;
  std::unique_ptr<Pipeline> Inner;
};

#endif
