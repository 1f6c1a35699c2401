/**
 * @class vtkOversketchShadingLevels
 * @brief grey layers between reference curve and boundary, and how far each vertex follows by them
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.2 to 5.5: white at
 * the curve, black at the boundary, in even steps to look at, continuous within; handles that are dragged
 * move the layers; areas have layers of their own. Kernels/Shading/layers.h and texels.h have what the thesis
 * leaves open. Departures, which AsPublished turns off: weights fall smoothly from the curve to the boundary
 * and over handles, where linear ones put an edge into the surface (Falloff); an area's weights blend with
 * those round it, where a step is a cliff (Feather).
 *
 * Input 0 (Mesh): with point arrays EditRegion and CurveDistance (vtkOversketchDistanceField).
 * Input 1 (Disc): the disc of that mesh, output 1 of vtkOversketchFlatten.
 * Input 2 (Areas, optional, vtkImageData): output 1 of vtkOversketchScanFill, an area for each component.
 *
 * Output 0 (Mesh): the same with point array EditWeight, double, 0 to 1; 0 where EditRegion is not 2. Weights
 * are exact at each vertex, not read from the image.
 * Output 1 (Weights, vtkImageData): Resolution x Resolution samples over the disc, x and y from -1 to 1, with
 * the float point array Weight; 0 outside the disc. A texel's share of the way is known to 1 / 8192.
 * Output 2 (Display, vtkImageData): the same with the unsigned char point array Grey, by steps: 255, 191,
 * 128, 64, 0 of five levels.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray; BadRegion for an EditRegion that is
 * none; BadMesh for a disc that is not this mesh's and a CurveDistance outside 0 to 1; BadStroke for Layers
 * that are not understood, levels other than 2 to 256, handles on a curve or too near to each other, an area
 * that there is not, and an image of areas that is not square. A mesh without points gives empty outputs
 * silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: linear in the region's vertices and
 * the texels, no system is solved; where shares lie on the texels, and areas' borders, are kept.
 *
 * @sa vtkOversketchFlatten vtkOversketchDistanceField vtkOversketchScanFill vtkOversketchTextureToWeight
 */
#ifndef vtkOversketchShadingLevels_h
#define vtkOversketchShadingLevels_h

#include "OversketchFiltersShadingModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <string>
#include <vector>

namespace oversketch
{
class Layers;
struct ShadedArea;
}

class vtkImageData;

class OVERSKETCHFILTERSSHADING_EXPORT vtkOversketchShadingLevels : public vtkOversketchFilter
{
public:
  static vtkOversketchShadingLevels* New();
  vtkTypeMacro(vtkOversketchShadingLevels, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The disc and the areas, on ports 1 and 2.
   */
  void SetDiscConnection(vtkAlgorithmOutput* disc) { this->SetInputConnection(1, disc); }
  void SetDiscData(vtkPolyData* disc) { this->SetInputData(1, disc); }
  void SetAreasConnection(vtkAlgorithmOutput* areas) { this->SetInputConnection(2, areas); }
  void SetAreasData(vtkDataObject* areas) { this->SetInputData(2, areas); }
  ///@}

  ///@{
  /**
   * The images, on ports 1 and 2.
   */
  vtkImageData* GetWeightsOutput();
  vtkImageData* GetDisplayOutput();
  ///@}

  ///@{
  /**
   * How many grey levels there are [2 to 256, default 5]. Weights do not depend on it.
   */
  vtkSetClampMacro(Levels, int, 2, 256);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Handles and areas, with ";" between them; empty (default): none. "handle FROM TO" holds what lies at
   * FROM by default and drags it to TO, both shares of the way from curve, 0, to boundary, 1. A handle does
   * not pass those before it. "area NUMBER LEVELS" begins the layers of an area, by the number of its stroke
   * from 0: without LEVELS it has as many as the whole, without handles of its own the whole's. For instance
   * "handle 0.4 0.2; area 0 9; handle 0.4 0.6".
   */
  void SetLayers(const char* text);
  const char* GetLayers() const { return this->Layers.c_str(); }
  ///@}

  enum FalloffType
  {
    SMOOTH = 0,
    LINEAR = 1
  };
  ///@{
  /**
   * How weights fall: Smooth (default), 1 - (10 s^3 - 15 s^4 + 6 s^5); Linear, as published, 1 - s.
   */
  vtkSetClampMacro(Falloff, int, SMOOTH, LINEAR);
  vtkGetMacro(Falloff, int);
  void SetFalloffToSmooth() { this->SetFalloff(SMOOTH); }
  void SetFalloffToLinear() { this->SetFalloff(LINEAR); }
  ///@}

  ///@{
  /**
   * How far inside its border an area's weights blend with those round it, as a share of the disc's radius [0
   * to 1, default 0.05; as published: 0, not at all].
   */
  vtkSetMacro(Feather, double);
  vtkGetMacro(Feather, double);
  ///@}

  ///@{
  /**
   * Texels along each side of the images, preferably a power of two [16 to 2048, default 512].
   */
  vtkSetClampMacro(Resolution, int, 16, 2048);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Shade as printed: linear, without feather, whatever Falloff and Feather say [default off].
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  ///@{
  /**
   * How many times texels have been found, and the disc shaded: executions that the kept ones did not answer.
   */
  vtkGetMacro(TexelCount, vtkIdType);
  vtkGetMacro(ShadeCount, vtkIdType);
  ///@}

protected:
  vtkOversketchShadingLevels();
  ~vtkOversketchShadingLevels() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  // Fills the cache where it does not answer.
  void Shade(vtkPolyData* mesh, vtkPolyData* disc, vtkImageData* areas);
  void Paint(vtkIdType points,
    const oversketch::Layers& whole,
    const std::vector<oversketch::ShadedArea>& areas);

  int Levels = 5;
  std::string Layers;
  int Falloff = SMOOTH;
  double Feather = 0.05;
  int Resolution = 512;
  bool AsPublished = false;
  vtkIdType TexelCount = 0;
  vtkIdType ShadeCount = 0;

  struct Cache;
};

#endif
