/**
 * @class vtkOversketchForEach
 * @brief drives a filter over every model of a collection, with one stroke for all or one for each
 *
 * For the thousand models that get the same treatment, on one machine or spread over the ranks of an MPI run.
 * SetFilter names the filter to drive: any vtkAlgorithm whose first input port takes a model, for instance
 * vtkOversketchOneStroke with its parameters set. It is run once per leaf, in order; its inputs are set here
 * and taken away again. There are as many inputs here as the filter has, and at least two.
 *
 * Input 0 (Models, vtkDataObjectTree): the models, a collection (vtkDataObjectTree: vtkMultiBlockDataSet,
 * vtkPartitionedDataSet, vtkPartitionedDataSetCollection, nested as they like).
 * Input 1 (Strokes, optional, vtkDataObject): what the filter's port 1 gets, a stroke as a
 * rule: one for all models (vtkPolyData, or whatever the filter takes), or a collection whose leaves stand at
 * the same flat indices as the models'. May be left out where the filter can do without. Inputs 2 and on are
 * the same for the filter's further ports.
 *
 * Output 0: a collection of the same type and structure (names and field data included) with what the filter
 * made of each model. A leaf that is absent stays absent, silently. A model that the filter refuses does not
 * stop the others: it is reported by one error that names the leaf (flat index and name, and the rank where
 * there are several) and says why; its leaf of the output is an empty one of the type that the filter puts
 * out, so that what is paired by index stays paired. GetNumberOfFailures counts such leaves, and the error
 * code is that of the first (InnerStep where the filter has none).
 *
 * Several ranks: each works on the leaves that it holds, no leaf travels. A single stroke is broadcast from
 * the first rank that has it, in every run and on every rank, whether it holds models or not, and so is what
 * further inputs hold for all models; a collection of strokes is to be spread like the models, as ParaView's
 * readers do for files of equal structure. The output of a model does not depend on the rank that it falls
 * to.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure), one message, output empty: no filter, or one
 * without input or output (Unexpected); strokes that do not stand where the models do, or no rank has what
 * the filter needs (BadStroke; a rank without models is silent). After AbortExecute the output is empty and
 * the error code Cancelled; call Modified() before the next Update.
 *
 * Memory: that of the filter for one model at a time, besides input and output.
 *
 * @sa vtkOversketchOneStroke vtkMultiProcessController
 */
#ifndef vtkOversketchForEach_h
#define vtkOversketchForEach_h

#include "OversketchFiltersSystemsModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for its members

class vtkMultiProcessController;

class OVERSKETCHFILTERSSYSTEMS_EXPORT vtkOversketchForEach : public vtkPassInputTypeAlgorithm
{
public:
  static vtkOversketchForEach* New();
  vtkTypeMacro(vtkOversketchForEach, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke or the collection of strokes, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkDataObject* stroke) { this->SetInputDataObject(1, stroke); }

  ///@{
  /**
   * The filter to drive. A change of its parameters makes this one run again. It tells how many inputs there
   * are, so it comes before what is connected to the third. Default none.
   */
  void SetFilter(vtkAlgorithm* filter);
  vtkAlgorithm* GetFilter() const { return this->Filter; }
  ///@}

  ///@{
  /**
   * Who the other ranks are. Default the process's global controller; none means that there are no others.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * Models of this rank that the filter refused in the last run.
   */
  vtkGetMacro(NumberOfFailures, int);

  /**
   * Includes the filter's.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkOversketchForEach();
  ~vtkOversketchForEach() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  // Sends every rank what is the same for all models; null where no rank has it.
  vtkSmartPointer<vtkDataObject> Broadcast(vtkDataObject* single);

  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  int NumberOfFailures = 0;
};

#endif
