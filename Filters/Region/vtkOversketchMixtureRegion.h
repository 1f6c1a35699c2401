/**
 * @class vtkOversketchMixtureRegion
 * @brief the region of a mesh that a stroke means, grown from its section by thickness
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 4.2 and 4.3, Eq. 8. Two Gaussian
 * mixtures are fitted by greedy EM to the shape diameter, scaled to [0, 1]: one to samples of the whole mesh,
 * one to the seeds, the vertices that the matched section's edges end at. From these the region grows over
 * neighbours v with ln p_fg(v) - ln p_whole(v) > Lambda (b - f), b and f the unselected and selected
 * neighbours of v; the energies are ours, the paper names a reference. Departures, each with its property:
 * - seeds come from the section's middle only (SeedMargin): a stroke's ends rest on the body;
 * - the seeds' mixture is widened by nearby vertices only while there are fewer than three seeds per
 * component, nearest first, and these are samples, not seeds: on a thin limb a tolerance of a tenth of the
 * model reaches the body;
 * - the unselected pieces that the region cuts off are selected too, but for the largest (FillIslands);
 * - a region of more than half of the area is grown again, near the section (LimitRunaway);
 * - the border moves to the nearest good place to cut (CutAtJunction): a minimum cut of the triangles round
 * it, cheap in concave valleys, as in mesh cutting from painted strokes. Thickness alone places a limb's
 * border some 5 % short, where the rays begin to see the body, and leaves patches where a limb is not of one
 * thickness. Before that, what was reached over a bridge narrower than half the seeds' thickness is taken
 * off: a finger's region spilled over the web to its neighbours. So is what lies beyond a fork whose branches
 * both lead back to the body, as on two legs that touch: a stroke over the foot moved the other leg too;
 * - where the section goes on beyond the region and is to move there, the border moves up to it, on a limb
 * all round (ReachEnds): else the moved part ends in a step, in the middle of a thickened thigh;
 * - where the section is one of a body, only what is near it is moved (ConfineToSection): thickness does not
 * tell parts of a body apart, and a back that was raised took tail and legs with it;
 * - so where the thickness is the same but for the rays' noise, as on a sphere (IgnoreNoise): the region was
 * a chance patch, which tore or held no vertex inside its border;
 * - samples are even over the surface, not random (EvenSamples): neither the vertices' order, nor their
 * density, nor a turn of the model changes the mixtures. They alone are scaled to [0, 1], so that nothing is
 * read of the others.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point array ShapeDiameter, double[1]
 * (vtkOversketchShapeDiameter). Non-manifold edges and borders are tolerated. Where that filter computes
 * on demand, values are asked for as they are read: of the samples and of what growing visits.
 * Input 1 (Handles): handles (vtkOversketchTargets): points with arrays MeshVertices[3], MeshWeights[3],
 * RelativePosition[1], UnmergedTarget[3] (read with ReachEnds or ConfineToSection), and field array
 * SectionLength[1], model length (read with these, LimitRunaway or Reach, and where IgnoreNoise takes hold).
 *
 * Output 0: the input with point arrays
 * - Region, unsigned char: 1 for vertices of the region,
 * - RegionSeed, unsigned char: 1 for the seeds, all of them in the region,
 * - RegionProbability, double in [0, 1]: p_fg / (p_fg + p_whole);
 * - with thickness on demand, ShapeDiameterKnown, unsigned char: 1 in the region and within four rings of it;
 * elsewhere ShapeDiameter and RegionProbability are 0.
 * Everything else is passed; nothing is interpolated or dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray; BadRegion without seeds and
 * where nothing would be left to hold the mesh. A mesh without points gives an empty output silently.
 *
 * Deterministic: samples are drawn by a generator with the fixed Seed. Device and host agree to 1e-5.
 *
 * Cost: milliseconds for the mixtures, then linear in the vertices, and rays on demand. The whole mesh's
 * mixture is kept while points, polygons, ShapeDiameter and its parameters stand; the output arrays while the
 * seeds do, too.
 *
 * @sa vtkOversketchShapeDiameter vtkOversketchTargets vtkOversketchRegionBorder
 */
#ifndef vtkOversketchMixtureRegion_h
#define vtkOversketchMixtureRegion_h

#include "OversketchFiltersRegionModule.h" // For export macro
#include "vtkOversketchBackendFilter.h"

class OVERSKETCHFILTERSREGION_EXPORT vtkOversketchMixtureRegion : public vtkOversketchBackendFilter
{
public:
  static vtkOversketchMixtureRegion* New();
  vtkTypeMacro(vtkOversketchMixtureRegion, vtkOversketchBackendFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The handles, on port 1.
   */
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(1, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(1, handles); }

  ///@{
  /**
   * Weight of the border's smoothness against the thickness, at least 0; default 0.2, the paper's lambda.
   */
  vtkSetClampMacro(Lambda, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Lambda, double);
  ///@}

  ///@{
  /**
   * Seeds have a RelativePosition in [SeedMargin, 1 - SeedMargin]; 0, as published, to 0.45, default 0.1.
   */
  vtkSetClampMacro(SeedMargin, double, 0.0, 0.45);
  vtkGetMacro(SeedMargin, double);
  ///@}

  ///@{
  /**
   * Select every piece that the region cuts off from the largest rest, by area, of its connected part;
   * default on. Off is as published: toes that are left out then stay behind and tear the foot.
   */
  vtkSetMacro(FillIslands, bool);
  vtkGetMacro(FillIslands, bool);
  vtkBooleanMacro(FillIslands, bool);
  ///@}

  ///@{
  /**
   * Where the region exceeds half of the area of the connected parts it lies in, grow it again within an edge
   * path of one section length of the seeds; default on. Off is as published.
   */
  vtkSetMacro(LimitRunaway, bool);
  vtkGetMacro(LimitRunaway, bool);
  vtkBooleanMacro(LimitRunaway, bool);
  ///@}

  ///@{
  /**
   * Take limbs behind narrow bridges and beyond forks off the region, then move its border to the nearest
   * good place to cut, up to 1.25 times the thickness there away; default on. Off is as published.
   */
  vtkSetMacro(CutAtJunction, bool);
  vtkGetMacro(CutAtJunction, bool);
  vtkBooleanMacro(CutAtJunction, bool);
  ///@}

  ///@{
  /**
   * Extend the region towards the section's ends, within SeedMargin, as far as the stroke moves it by over a
   * twentieth of what it moves it most and a thousandth of its length; default on. Off is as published.
   */
  vtkSetMacro(ReachEnds, bool);
  vtkGetMacro(ReachEnds, bool);
  vtkBooleanMacro(ReachEnds, bool);
  ///@}

  ///@{
  /**
   * Keep only what is near to a seed, along edges, where the section is one of a body: the region exceeds a
   * fifth of the area of the connected parts it lies in, and the seeds' median thickness is over 1.25 times
   * what the section reaches, half of its length, or a quarter where it is straight (in between by the
   * distance of its ends over its length). Near is what it reaches, at least 1.25 times the farthest that the
   * stroke moves it, and where that goes into the body 1.5 times the way along a circle of that thickness to
   * as deep below: else the flanks would become the outline. Default on, off is as published.
   */
  vtkSetMacro(ConfineToSection, bool);
  vtkGetMacro(ConfineToSection, bool);
  vtkBooleanMacro(ConfineToSection, bool);
  ///@}

  ///@{
  /**
   * Then move the border along edges by this, outwards where positive [lengths of the section, -1 to 1,
   * default 0]. Seeds stay in the region.
   */
  vtkSetClampMacro(Reach, double, -1.0, 1.0);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * Take the samples in the order of the vertices' distances from the middle of the surface at equal steps of
   * its area, of the seeds in the order of their values at equal steps of their number; default on. Off: at
   * random, as published, by the vertices' numbers and density, scaled by the least and greatest value of
   * all.
   */
  vtkSetMacro(EvenSamples, bool);
  vtkGetMacro(EvenSamples, bool);
  vtkBooleanMacro(EvenSamples, bool);
  ///@}

  ///@{
  /**
   * Where the thickness' standard deviation is less than a fiftieth of its mean, take what is near to a seed
   * as ConfineToSection has it, its neighbours at least, and look for no junction; default on. Off, as
   * published, noise decides.
   */
  vtkSetMacro(IgnoreNoise, bool);
  vtkGetMacro(IgnoreNoise, bool);
  vtkBooleanMacro(IgnoreNoise, bool);
  ///@}

  ///@{
  /**
   * Most components of a mixture, 1 to 8; default 4 (Table 2); of the seeds' a third of the samples at most.
   */
  vtkSetClampMacro(Components, int, 1, 8);
  vtkGetMacro(Components, int);
  ///@}

  ///@{
  /**
   * Seed of the generator that draws samples, EvenSamples being off; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * How many times the whole mesh's mixture has been fitted, to how many samples; how many times a region has
   * been grown.
   */
  vtkGetMacro(WholeFitCount, vtkIdType);
  vtkGetMacro(WholeSampleCount, vtkIdType);
  vtkGetMacro(GrowthCount, vtkIdType);
  ///@}

  /**
   * Fits the mixture of a whole mesh of one part, input 0 as it is, so that the next Update need not. Errors
   * as of an update.
   */
  void Prepare();

protected:
  vtkOversketchMixtureRegion() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchMixtureRegion() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Lambda = 0.2;
  double SeedMargin = 0.1;
  bool FillIslands = true;
  bool LimitRunaway = true;
  bool CutAtJunction = true;
  bool ReachEnds = true;
  bool ConfineToSection = true;
  double Reach = 0.0;
  bool EvenSamples = true;
  bool IgnoreNoise = true;
  int Components = 4;
  int Seed = 1;
  vtkIdType WholeFitCount = 0;
  vtkIdType GrowthCount = 0;
  vtkIdType WholeSampleCount = 0;

  struct Cache;
};

#endif
