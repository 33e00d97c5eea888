<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es-ES" sourcelanguage="en">
 <context>
  <name>AnisoQuadPreferences</name>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>1st</source>
   <translation>1.º</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1.º: cuatro nodos por cuadrilátero; 2.º: ocho, los nodos intermedios sobre la superficie</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2.º</translation>
  </message>
  <message>
   <source>Defaults of new objects</source>
   <translation>Valores por defecto de los objetos nuevos</translation>
  </message>
  <message>
   <source>Element order of a quad mesh</source>
   <translation>Orden de los elementos de una malla de cuadriláteros</translation>
  </message>
  <message>
   <source>General</source>
   <translation>General</translation>
  </message>
  <message>
   <source>Hide the triangles once the quads are there</source>
   <translation>Ocultar los triángulos cuando estén los cuadriláteros</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become</source>
   <translation>Cuántas veces más largos que altos serán los cuadriláteros junto a la línea</translation>
  </message>
  <message>
   <source>Maximum anisotropy of a source</source>
   <translation>Anisotropía máxima de una fuente</translation>
  </message>
  <message>
   <source>View</source>
   <translation>Vista</translation>
  </message>
  <message>
   <source>Width of source lines</source>
   <translation>Anchura de las líneas de las fuentes</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_AddSource</name>
  <message>
   <source>Add anisotropy source</source>
   <translation>Añadir fuente de anisotropía</translation>
  </message>
  <message>
   <source>Adds a line along which rows of long, thin quads are built, such as the leading edge of a wing, and opens a panel to pick it in the view: a click starts the line, a further one extends it along the ridge, a double click takes the whole line, a click with Ctrl cuts it, Esc leaves picking. With edges of a Part object selected, the mesh edges on them are the line. With a quad mesh selected, that one gets the source.</source>
   <translation>Añade una línea junto a la cual se construyen filas de cuadriláteros largos y finos, como el borde de ataque de un ala, y abre un panel para elegirla en la vista: un clic empieza la línea, otro la prolonga por la cresta, un doble clic toma toda la línea, un clic con Ctrl la corta, Esc sale. Si hay aristas de un objeto Part seleccionadas, las aristas de la malla sobre ellas son la línea. Si hay una malla de cuadriláteros seleccionada, ella recibe la fuente.</translation>
  </message>
  <message>
   <source>Pick a line on the selected mesh along which rows of long thin quads are built;
with edges of a Part object selected, they are the line</source>
   <translation>Elegir en la malla seleccionada una línea junto a la cual se construyen filas de cuadriláteros largos y finos;
si hay aristas de un objeto Part seleccionadas, ellas son la línea</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Edit</name>
  <message>
   <source>Change the selected quad mesh or source</source>
   <translation>Cambiar la malla de cuadriláteros o la fuente seleccionada</translation>
  </message>
  <message>
   <source>Edit</source>
   <translation>Editar</translation>
  </message>
  <message>
   <source>Opens the panel of the selected quad mesh or source, as a double click in the tree does. Cancel takes back everything that was changed in it.</source>
   <translation>Abre el panel de la malla de cuadriláteros o de la fuente seleccionada, como un doble clic en el árbol. Cancelar deshace todo lo que se cambió en él.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Export</name>
  <message>
   <source>Export</source>
   <translation>Exportar</translation>
  </message>
  <message>
   <source>Export quad mesh</source>
   <translation>Exportar malla de cuadriláteros</translation>
  </message>
  <message>
   <source>Write the selected quad mesh as .vtu, .inp, .msh, .su2 or .obj</source>
   <translation>Escribir la malla de cuadriláteros seleccionada como .vtu, .inp, .msh, .su2 u .obj</translation>
  </message>
  <message>
   <source>Writes the selected quad mesh to a file: .vtu for ParaView, .inp for CalculiX and Abaqus, .msh for Gmsh, .su2 for SU2, .obj for other programs. Patches, rows, feature lines and sources are kept as named sets where the format has them.</source>
   <translation>Escribe la malla de cuadriláteros seleccionada en un archivo: .vtu para ParaView, .inp para CalculiX y Abaqus, .msh para Gmsh, .su2 para SU2, .obj para otros programas. Las caras, filas, líneas características y fuentes se conservan como conjuntos con nombre donde el formato los tiene.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Preferences</name>
  <message>
   <source>Defaults of new quad meshes and sources</source>
   <translation>Valores por defecto de mallas y fuentes nuevas</translation>
  </message>
  <message>
   <source>Opens the preferences of the workbench: the anisotropy of new sources, the element order of new quad meshes, whether the triangles are hidden once the quads are there, and the width of the lines of sources.</source>
   <translation>Abre las preferencias del entorno de trabajo: la anisotropía de las fuentes nuevas, el orden de los elementos de las mallas nuevas, si los triángulos se ocultan cuando están los cuadriláteros y el ancho de las líneas de las fuentes.</translation>
  </message>
  <message>
   <source>Preferences</source>
   <translation>Preferencias</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_QuadMesh</name>
  <message>
   <source>Make an all-quad surface mesh of the selected triangle mesh or Part shape,
with the sources that were added to it before</source>
   <translation>Hacer una malla de superficie solo de cuadriláteros de la malla de triángulos o forma Part seleccionada,
con las fuentes que se le añadieron antes</translation>
  </message>
  <message>
   <source>Makes a quad mesh of the selected triangle mesh, and opens its panel, in which meshing starts at once. A Part shape is triangulated first. Sources that were added to the triangles before get their rows of long, thin quads. The quad mesh follows its triangles, sources and options: when they change, it is made anew. With an active analysis it becomes a part of it.</source>
   <translation>Hace una malla de cuadriláteros de la malla de triángulos seleccionada y abre su panel, donde el mallado empieza enseguida. Una forma Part se triangula primero. Las fuentes añadidas antes a los triángulos reciben sus filas de cuadriláteros largos y finos. La malla sigue a sus triángulos, fuentes y opciones: cuando cambian, se hace de nuevo. Si hay un análisis activo, pasa a ser parte de él.</translation>
  </message>
  <message>
   <source>Quad mesh from mesh</source>
   <translation>Malla de cuadriláteros a partir de malla</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Quality</name>
  <message>
   <source>Colour the selected quad mesh by its quality, and list the worst quads</source>
   <translation>Colorear la malla seleccionada según su calidad y listar los peores cuadriláteros</translation>
  </message>
  <message>
   <source>Colours the selected quad mesh by a measure of its quads: scaled Jacobian, aspect ratio, skew, size or row. Red is bad, blue is good. The panel shows the measure's histogram, and lists the worst quads; a click on one zooms to it. Closing the panel brings the mesh's own look back.</source>
   <translation>Colorea la malla de cuadriláteros seleccionada según una medida: jacobiano escalado, relación de aspecto, sesgo, tamaño o fila. Rojo es malo, azul es bueno. El panel muestra el histograma de la medida y da los peores cuadriláteros; un clic en uno lo enfoca. Al cerrar el panel, la malla recupera su aspecto.</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Calidad</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_SuggestSources</name>
  <message>
   <source>Find the leading and trailing edges of the selected mesh</source>
   <translation>Encontrar los bordes de ataque y de salida de la malla seleccionada</translation>
  </message>
  <message>
   <source>Looks for long, smooth ridges of the selected mesh, as leading and trailing edges are, and lists them in a panel. Those that are ticked become sources. With a quad mesh selected, that one gets them.</source>
   <translation>Busca crestas largas y suaves de la malla seleccionada, como son los bordes de ataque y de salida, y las muestra en una lista. Las marcadas se convierten en fuentes. Si hay una malla de cuadriláteros seleccionada, ella las recibe.</translation>
  </message>
  <message>
   <source>Suggest leading edges</source>
   <translation>Sugerir bordes de ataque</translation>
  </message>
 </context>
 <context>
  <name>App::Property</name>
  <message>
   <source>1st: four nodes a quad; 2nd: eight</source>
   <translation>1.º: cuatro nodos por cuadrilátero; 2.º: ocho</translation>
  </message>
  <message>
   <source>All figures of the run, as JSON</source>
   <translation>Todas las cifras del cálculo, como JSON</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Grados que puede girar una arista a lo largo de la superficie donde se mallan caras de nuevo; 0: cualquiera</translation>
  </message>
  <message>
   <source>Degrees that one edge of Gmsh's triangles may turn along the surface; 0: any</source>
   <translation>Grados que puede girar una arista de los triángulos de Gmsh a lo largo de la superficie; 0: cualquiera</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Grados; las aristas en que los triángulos giran más son líneas características</translation>
  </message>
  <message>
   <source>Edges of a Part object instead: the mesh edges on them are the line</source>
   <translation>O aristas de un objeto Part: las aristas de la malla sobre ellas son la línea</translation>
  </message>
  <message>
   <source>Faces of the Part object whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Las caras del objeto Part cuyas normales difieren menos donde se juntan son un solo trozo; 0: cada una es uno</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Otras aristas características, como pares de números de puntos de entrada</translation>
  </message>
  <message>
   <source>Largest angle between the normals of neighbours, by OpenCASCADE</source>
   <translation>Mayor ángulo entre las normales de vecinos, con OpenCASCADE</translation>
  </message>
  <message>
   <source>Largest distance between the mesh and the base mesh</source>
   <translation>Mayor distancia entre la malla y la malla de base</translation>
  </message>
  <message>
   <source>Largest distance of OpenCASCADE's triangles from the shape; 0: a five-thousandth of its diagonal</source>
   <translation>Mayor distancia de los triángulos de OpenCASCADE a la forma; 0: una cinco milésima parte de su diagonal</translation>
  </message>
  <message>
   <source>Largest edge of Gmsh's triangles; 0: a tenth of the shape's diagonal</source>
   <translation>Arista más larga de los triángulos de Gmsh; 0: una décima parte de la diagonal de la forma</translation>
  </message>
  <message>
   <source>Largest edge of well-shaped triangles by OpenCASCADE (Mefisto) instead; 0: as large as deflection and angle allow</source>
   <translation>O arista más larga de triángulos de buena forma con OpenCASCADE (Mefisto); 0: tan grande como permitan la desviación y el ángulo</translation>
  </message>
  <message>
   <source>Length of the line</source>
   <translation>Longitud de la línea</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Límite entre los tamaños de elementos vecinos donde se mallan caras de nuevo</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Límite de pasadas del suavizado final</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Límite de la altura de una fila respecto a la anterior; las últimas, que llevan a cuadriláteros isótropos, pueden crecer 1,6 veces</translation>
  </message>
  <message>
   <source>Lines along which anisotropic rows are built</source>
   <translation>Líneas a lo largo de las cuales se construyen filas anisótropas</translation>
  </message>
  <message>
   <source>Maximum anisotropy, used where no passes are given; 1: a feature line without rows</source>
   <translation>Anisotropía máxima, si no se dan pasadas; 1: línea característica sin filas</translation>
  </message>
  <message>
   <source>Mean scaled Jacobian</source>
   <translation>Jacobiano escalado medio</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Reparar una entrada mala en vez de rechazarla; el informe dice qué se cambió</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with rows or not: 4:6, 2, 2</source>
   <translation>Relación de fusión de cada pasada, con su número de filas o sin él: 4:6, 2, 2</translation>
  </message>
  <message>
   <source>Number of corner nodes</source>
   <translation>Número de nodos de esquina</translation>
  </message>
  <message>
   <source>Number of mesh edges</source>
   <translation>Número de aristas de la malla</translation>
  </message>
  <message>
   <source>Number of quads</source>
   <translation>Número de cuadriláteros</translation>
  </message>
  <message>
   <source>Number of triangles of the base mesh</source>
   <translation>Número de triángulos de la malla de base</translation>
  </message>
  <message>
   <source>OpenCASCADE: as few triangles as Deflection and Angle allow; Gmsh: triangles of good shape, by Size and Curvature Angle</source>
   <translation>OpenCASCADE: tan pocos triángulos como permitan Deflection y Angle; Gmsh: triángulos de buena forma según Size y Curvature Angle</translation>
  </message>
  <message>
   <source>Percent of elements saved</source>
   <translation>Porcentaje de elementos ahorrados</translation>
  </message>
  <message>
   <source>Percent of interior nodes with four edges</source>
   <translation>Porcentaje de nodos interiores con cuatro aristas</translation>
  </message>
  <message>
   <source>Point ids of the base mesh; closed when the first is also the last</source>
   <translation>Números de puntos de la malla de base; cerrada cuando el primero es también el último</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Mallar primero de nuevo las caras cuyos triángulos no pueden llevar cuadriláteros: demasiado largos y finos, o de tamaño que cambia demasiado rápido</translation>
  </message>
  <message>
   <source>Row, pass, source, patch of the quads; lines</source>
   <translation>Fila, pasada, fuente y trozo de los cuadriláteros; líneas</translation>
  </message>
  <message>
   <source>Rows of each pass, and why they stopped</source>
   <translation>Filas de cada pasada, y por qué acaban</translation>
  </message>
  <message>
   <source>Scaled Jacobian of the worst quad</source>
   <translation>Jacobiano escalado del peor cuadrilátero</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Lados de la línea, vista a lo largo con la normal hacia arriba, que reciben filas</translation>
  </message>
  <message>
   <source>Straighten a line that zigzags over the triangles before rows start</source>
   <translation>Enderezar una línea que zigzaguea por los triángulos antes de las filas</translation>
  </message>
  <message>
   <source>The Part object</source>
   <translation>El objeto Part</translation>
  </message>
  <message>
   <source>The Part object on which the mesh lies, where FEM looks for it</source>
   <translation>El objeto Part sobre el que está la malla, donde FEM lo busca</translation>
  </message>
  <message>
   <source>The base mesh of the last run</source>
   <translation>La malla de base del último cálculo</translation>
  </message>
  <message>
   <source>The line runs against its first edge: left and right change</source>
   <translation>La línea va en contra de su primera arista: se cambian izquierda y derecha</translation>
  </message>
  <message>
   <source>The line's points in the world</source>
   <translation>Los puntos de la línea en el espacio</translation>
  </message>
  <message>
   <source>The triangle mesh</source>
   <translation>La malla de triángulos</translation>
  </message>
  <message>
   <source>The triangle mesh on which the line lies</source>
   <translation>La malla de triángulos sobre la que está la línea</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Limpieza topológica tras el relleno</translation>
  </message>
  <message>
   <source>Version of these properties</source>
   <translation>Versión de estas propiedades</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Longitud de arista deseada de los cuadriláteros; malla de nuevo todas las caras. 0: la de los triángulos</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Longitudes de arista deseadas, una por punto de entrada, en vez del tamaño</translation>
  </message>
  <message>
   <source>What the mesher warns of</source>
   <translation>De qué avisa el mallador</translation>
  </message>
  <message>
   <source>Where the base is the tessellation of a Part object: patches are its faces, and nodes lie exactly on it</source>
   <translation>Si la base es la triangulación de un objeto Part: los trozos son sus caras y los nodos están exactamente sobre él</translation>
  </message>
 </context>
 <context>
  <name>Options</name>
  <message>
   <source>Cleanup</source>
   <translation>Limpieza</translation>
  </message>
  <message>
   <source>Curvature angle</source>
   <translation>Ángulo de curvatura</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Grados que puede girar una arista a lo largo de la superficie donde se mallan caras de nuevo; 0: cualquiera</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Grados; las aristas en que los triángulos giran más son líneas características</translation>
  </message>
  <message>
   <source>Feature angle</source>
   <translation>Ángulo de aristas vivas</translation>
  </message>
  <message>
   <source>Feature edges</source>
   <translation>Aristas características</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Otras aristas características, como pares de números de puntos de entrada</translation>
  </message>
  <message>
   <source>Growth</source>
   <translation>Crecimiento</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Límite entre los tamaños de elementos vecinos donde se mallan caras de nuevo</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Límite de pasadas del suavizado final</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Límite de la altura de una fila respecto a la anterior; las últimas, que llevan a cuadriláteros isótropos, pueden crecer 1,6 veces</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Reparar una entrada mala en vez de rechazarla; el informe dice qué se cambió</translation>
  </message>
  <message>
   <source>Prepare</source>
   <translation>Preparar</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Mallar primero de nuevo las caras cuyos triángulos no pueden llevar cuadriláteros: demasiado largos y finos, o de tamaño que cambia demasiado rápido</translation>
  </message>
  <message>
   <source>Repair</source>
   <translation>Reparar</translation>
  </message>
  <message>
   <source>Row growth</source>
   <translation>Crecimiento de las filas</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Tamaño</translation>
  </message>
  <message>
   <source>Smoothing passes</source>
   <translation>Pasadas de suavizado</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Limpieza topológica tras el relleno</translation>
  </message>
  <message>
   <source>Vertex size</source>
   <translation>Tamaño en los puntos</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Longitud de arista deseada de los cuadriláteros; malla de nuevo todas las caras. 0: la de los triángulos</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Longitudes de arista deseadas, una por punto de entrada, en vez del tamaño</translation>
  </message>
 </context>
 <context>
  <name>QuadMeshPanel</name>
  <message>
   <source>1:16 is the maximum anisotropy; 4:6, 2, 2 are the merge ratios of the passes, the first with six rows</source>
   <translation>1:16 es la anisotropía máxima; 4:6, 2, 2 son las razones de fusión de las pasadas, la primera con seis filas</translation>
  </message>
  <message>
   <source>1st</source>
   <translation>1.º</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1.º: cuatro nodos por cuadrilátero; 2.º: ocho, los nodos intermedios sobre la superficie</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2.º</translation>
  </message>
  <message>
   <source>A quad mesh is made of a triangle mesh, and follows it: when the triangles, a source or an option change, it is made anew. Apply meshes and keeps the panel open; OK closes it; Cancel takes everything back. While it meshes, the window stays alive, and Stop keeps the old mesh.</source>
   <translation>Una malla de cuadriláteros se hace de una malla de triángulos y la sigue: cuando cambian los triángulos, una fuente o una opción, se hace de nuevo. Aplicar malla y deja el panel abierto; Aceptar lo cierra; Cancelar lo deshace todo. Mientras malla, la ventana sigue viva, y Parar conserva la malla anterior.</translation>
  </message>
  <message>
   <source>Add…</source>
   <translation>Añadir…</translation>
  </message>
  <message>
   <source>Anisotropy sources</source>
   <translation>Fuentes de anisotropía</translation>
  </message>
  <message>
   <source>CAD shape</source>
   <translation>Forma CAD</translation>
  </message>
  <message>
   <source>Change the selected source</source>
   <translation>Cambiar la fuente seleccionada</translation>
  </message>
  <message>
   <source>Do not use the selected source any more</source>
   <translation>No usar más la fuente seleccionada</translation>
  </message>
  <message>
   <source>Draw where rows will come</source>
   <translation>Dibujar dónde habrá filas</translation>
  </message>
  <message>
   <source>Edges</source>
   <translation>Aristas</translation>
  </message>
  <message>
   <source>Edit…</source>
   <translation>Editar…</translation>
  </message>
  <message>
   <source>Element order</source>
   <translation>Orden de los elementos</translation>
  </message>
  <message>
   <source>Faces of the shape that go on into each other smoothly, as a fillet and what it rounds, can be one patch, over which quads flow without a line between. Give the degrees by which their normals may differ where they meet, for instance 5. With 0 each face is a patch.</source>
   <translation>Las caras de la forma que continúan unas en otras con suavidad, como un redondeo y lo que redondea, pueden ser un solo trozo, por el que los cuadriláteros pasan sin línea entre ellas. Dé los grados en que pueden diferir sus normales donde se juntan, por ejemplo 5. Con 0 cada cara es un trozo.</translation>
  </message>
  <message>
   <source>Faces whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Las caras cuyas normales difieren menos donde se juntan son un solo trozo; 0: cada una es uno</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longitud</translation>
  </message>
  <message>
   <source>Lines along which rows of long thin quads are built; a selected line is shown in the view</source>
   <translation>Líneas junto a las cuales se construyen filas de cuadriláteros largos y finos; la seleccionada se muestra en la vista</translation>
  </message>
  <message>
   <source>Meshing…</source>
   <translation>Mallando…</translation>
  </message>
  <message>
   <source>On: the patches of the mesh are the faces of the Part shape, its lines are their edges, and all nodes lie exactly on it. Off: only the triangles count, and lines are where they bend.</source>
   <translation>Marcado: los trozos de la malla son las caras de la forma Part, sus líneas son las aristas de estas y todos los nodos están exactamente sobre ella. Sin marcar: solo cuentan los triángulos, y hay líneas donde se doblan.</translation>
  </message>
  <message>
   <source>Onto shape</source>
   <translation>Sobre la forma</translation>
  </message>
  <message>
   <source>OpenCASCADE makes as few triangles as show the shape; they are remeshed before they become quads. Gmsh is a program of its own, on Debian the package gmsh: its triangles have a good shape, the size that is asked for in the options, and are finer where the surface turns, as at a leading edge. They are made anew at the next Apply; Stop ends Gmsh.</source>
   <translation>OpenCASCADE hace tan pocos triángulos como bastan para mostrar la forma; se mallan de nuevo antes de ser cuadriláteros. Gmsh es un programa aparte, en Debian el paquete gmsh: sus triángulos tienen buena forma, el tamaño que se pide en las opciones, y son más finos donde la superficie gira, como en un borde de ataque. Se hacen de nuevo con el siguiente Aplicar; Parar termina Gmsh.</translation>
  </message>
  <message>
   <source>Options</source>
   <translation>Opciones</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Pasadas</translation>
  </message>
  <message>
   <source>Patches are the faces of the shape, and all nodes lie exactly on it</source>
   <translation>Los trozos son las caras de la forma, y todos los nodos están exactamente sobre ella</translation>
  </message>
  <message>
   <source>Pick a new line in the view</source>
   <translation>Elegir una línea nueva en la vista</translation>
  </message>
  <message>
   <source>Preview rows</source>
   <translation>Previsualizar filas</translation>
  </message>
  <message>
   <source>Quad mesh</source>
   <translation>Malla de cuadriláteros</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Quitar</translation>
  </message>
  <message>
   <source>Scaled Jacobian: worst {worst:.3f}, mean {mean:.3f}; regular nodes: {regular:.1f} %</source>
   <translation>Jacobiano escalado: peor {worst:.3f}, medio {mean:.3f}; nodos regulares: {regular:.1f} %</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Lados</translation>
  </message>
  <message>
   <source>Smooth angle</source>
   <translation>Ángulo de suavidad</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Fuente</translation>
  </message>
  <message>
   <source>Source {source} has no rows, {side}: {why}</source>
   <translation>La fuente {source} no tiene filas, {side}: {why}</translation>
  </message>
  <message>
   <source>Source {source}, pass {pass_} (1:{ratio}): rows {counts}</source>
   <translation>Fuente {source}, pasada {pass_} (1:{ratio}): filas {counts}</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Parar</translation>
  </message>
  <message>
   <source>Stop meshing; the old mesh stays</source>
   <translation>Parar el mallado; la malla anterior se conserva</translation>
  </message>
  <message>
   <source>Stopped. The old mesh was kept.</source>
   <translation>Parado. Se conservó la malla anterior.</translation>
  </message>
  <message>
   <source>The triangle mesh that is turned into quads</source>
   <translation>La malla de triángulos que se convierte en cuadriláteros</translation>
  </message>
  <message>
   <source>Triangles</source>
   <translation>Triángulos</translation>
  </message>
  <message>
   <source>Triangulator</source>
   <translation>Triángulos de</translation>
  </message>
  <message>
   <source>Warning: {}</source>
   <translation>Aviso: {}</translation>
  </message>
  <message>
   <source>What makes the triangles of the shape; Gmsh takes size and curvature angle of the options</source>
   <translation>Qué hace los triángulos de la forma; Gmsh toma el tamaño y el ángulo de curvatura de las opciones</translation>
  </message>
  <message>
   <source>Where the triangles are those of a Part shape, the quads can lie on the shape itself: its faces are the patches, its edges the lines of the mesh. Gmsh, where it is installed, makes triangles of good shape in the size that the options ask for, and of a fineness that follows the curvature; OpenCASCADE makes as few as show the shape, which are then remeshed.</source>
   <translation>Si los triángulos son los de una forma Part, los cuadriláteros pueden estar sobre la forma misma: sus caras son los trozos, sus aristas las líneas de la malla. Gmsh, si está instalado, hace triángulos de buena forma del tamaño que piden las opciones y de una finura que sigue la curvatura; OpenCASCADE hace tan pocos como bastan para mostrar la forma, que después se mallan de nuevo.</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles</source>
   <translation>{quads} cuadriláteros a partir de {triangles} triángulos</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles ({reduction:.1f} % fewer elements)</source>
   <translation>{quads} cuadriláteros de {triangles} triángulos ({reduction:.1f} % menos elementos)</translation>
  </message>
  <message>
   <source>°</source>
   <translation>°</translation>
  </message>
 </context>
 <context>
  <name>QualityPanel</name>
  <message>
   <source>Aspect ratio</source>
   <translation>Relación de aspecto</translation>
  </message>
  <message>
   <source>Element</source>
   <translation>Elemento</translation>
  </message>
  <message>
   <source>Number of quads (logarithmic) over the measure</source>
   <translation>Número de cuadriláteros (logarítmico) según la medida</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Calidad</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Fila</translation>
  </message>
  <message>
   <source>Scaled Jacobian</source>
   <translation>Jacobiano escalado</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Tamaño</translation>
  </message>
  <message>
   <source>Skew</source>
   <translation>Sesgo</translation>
  </message>
  <message>
   <source>The quads are coloured by the chosen measure: red is bad, blue is good. The scaled Jacobian is 1 for a rectangle and 0 for a quad that is folded flat; thin quads of anisotropic rows keep a good one.</source>
   <translation>Los cuadriláteros se colorean según la medida elegida: rojo es malo, azul es bueno. El jacobiano escalado es 1 para un rectángulo y 0 para un cuadrilátero plegado; los cuadriláteros finos de las filas anisótropas lo conservan bueno.</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valor</translation>
  </message>
  <message>
   <source>What the quads are coloured by</source>
   <translation>Según qué se colorean los cuadriláteros</translation>
  </message>
  <message>
   <source>Worst quads; a click zooms to them:</source>
   <translation>Peores cuadriláteros; un clic los enfoca:</translation>
  </message>
  <message>
   <source>matplotlib is not installed: no histogram</source>
   <translation>matplotlib no está instalado: sin histograma</translation>
  </message>
  <message>
   <source>{low:.4g} … {high:.4g}, mean {mean:.4g}</source>
   <translation>{low:.4g} … {high:.4g}, media {mean:.4g}</translation>
  </message>
 </context>
 <context>
  <name>Report</name>
  <message>
   <source>Source {source}, {side}, pass {pass_} (1:{ratio}): {rows} rows of {columns} columns; {why}</source>
   <translation>Fuente {source}, {side}, pasada {pass_} (1:{ratio}): {rows} filas de {columns} columnas; {why}</translation>
  </message>
  <message>
   <source>a boundary, a feature line or another row is too close ahead</source>
   <translation>un borde, una línea característica u otra fila está demasiado cerca por delante</translation>
  </message>
  <message>
   <source>a column has become too slim</source>
   <translation>una columna se ha vuelto demasiado estrecha</translation>
  </message>
  <message>
   <source>a quad of the row would be too distorted</source>
   <translation>un cuadrilátero de la fila quedaría demasiado deformado</translation>
  </message>
  <message>
   <source>another row or the boundary lies directly ahead</source>
   <translation>otra fila o el borde está justo delante</translation>
  </message>
  <message>
   <source>as many rows as asked for</source>
   <translation>tantas filas como se pidieron</translation>
  </message>
  <message>
   <source>in {} of them the triangles turn too far from one to the next</source>
   <translation>en {} de ellas los triángulos giran demasiado de uno al siguiente</translation>
  </message>
  <message>
   <source>in {} of them the triangles' size changes too fast</source>
   <translation>en {} de ellas el tamaño de los triángulos cambia demasiado rápido</translation>
  </message>
  <message>
   <source>invalid faces of the shape were taken as they are</source>
   <translation>las caras no válidas de la forma se tomaron tal como son</translation>
  </message>
  <message>
   <source>let Gmsh make them</source>
   <translation>que los haga Gmsh</translation>
  </message>
  <message>
   <source>something lies inside the row</source>
   <translation>hay algo dentro de la fila</translation>
  </message>
  <message>
   <source>the edges of {} triangles were turned because some were thinner than {} of the diagonal</source>
   <translation>se giraron las aristas de {} triángulos porque algunos eran más delgados que {} de la diagonal</translation>
  </message>
  <message>
   <source>the end column reaches a corner of the feature lines</source>
   <translation>la columna del extremo llega a una esquina de las líneas características</translation>
  </message>
  <message>
   <source>the front turns too sharply for one more row</source>
   <translation>el frente gira demasiado bruscamente para una fila más</translation>
  </message>
  <message>
   <source>the input was repaired</source>
   <translation>la entrada se reparó</translation>
  </message>
  <message>
   <source>the line at the row's end turns back to it</source>
   <translation>la línea al final de la fila vuelve hacia ella</translation>
  </message>
  <message>
   <source>the shape's triangles are folded over at {} edges</source>
   <translation>los triángulos de la forma están plegados en {} aristas</translation>
  </message>
  <message>
   <source>the triangles ahead are too large for the length of the front's edges</source>
   <translation>los triángulos de delante son demasiado grandes para la longitud de las aristas del frente</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (column)</source>
   <translation>los triángulos de delante no se pudieron voltear para formar la fila (columna)</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (top)</source>
   <translation>los triángulos de delante no se pudieron voltear para formar la fila (borde superior)</translation>
  </message>
  <message>
   <source>{} edge cut apart</source>
   <translation>{} arista separada</translation>
  </message>
  <message>
   <source>{} edges cut apart</source>
   <translation>{} aristas separadas</translation>
  </message>
  <message>
   <source>{} edges were collapsed because they are shorter than {} of the diagonal</source>
   <translation>{} aristas se contrajeron porque son más cortas que {} de la diagonal</translation>
  </message>
  <message>
   <source>{} facet doubled dropped</source>
   <translation>{} faceta doble descartada</translation>
  </message>
  <message>
   <source>{} facet turned</source>
   <translation>{} faceta volteada</translation>
  </message>
  <message>
   <source>{} facet without all vertices dropped</source>
   <translation>{} faceta sin todos sus vértices descartada</translation>
  </message>
  <message>
   <source>{} facet without area removed</source>
   <translation>{} faceta sin área eliminada</translation>
  </message>
  <message>
   <source>{} facet without finite coordinates dropped</source>
   <translation>{} faceta sin coordenadas finitas descartada</translation>
  </message>
  <message>
   <source>{} facets doubled dropped</source>
   <translation>{} facetas dobles descartadas</translation>
  </message>
  <message>
   <source>{} facets turned</source>
   <translation>{} facetas volteadas</translation>
  </message>
  <message>
   <source>{} facets without all vertices dropped</source>
   <translation>{} facetas sin todos sus vértices descartadas</translation>
  </message>
  <message>
   <source>{} facets without area removed</source>
   <translation>{} facetas sin área eliminadas</translation>
  </message>
  <message>
   <source>{} facets without finite coordinates dropped</source>
   <translation>{} facetas sin coordenadas finitas descartadas</translation>
  </message>
  <message>
   <source>{} of them have triangles too long and thin for quads ({} triangles)</source>
   <translation>{} de ellas tienen triángulos demasiado largos y finos para cuadriláteros ({} triángulos)</translation>
  </message>
  <message>
   <source>{} patches have an odd boundary that nothing can make even</source>
   <translation>{} caras tienen un borde con número impar de aristas que nada puede hacer par</translation>
  </message>
  <message>
   <source>{} patches were remeshed before: {} triangles became {}, edges up to {}</source>
   <translation>{} caras se mallaron antes de nuevo: {} triángulos pasaron a ser {}, aristas de hasta {}</translation>
  </message>
  <message>
   <source>{} quads are turned over by the surface to which they were brought</source>
   <translation>{} cuadriláteros quedan vueltos por la superficie a la que se llevaron</translation>
  </message>
  <message>
   <source>{} source nodes could not be merged</source>
   <translation>{} nodos de la fuente no se pudieron fusionar</translation>
  </message>
  <message>
   <source>{} triangles are left</source>
   <translation>quedan {} triángulos</translation>
  </message>
  <message>
   <source>{} vertex added</source>
   <translation>{} vértice añadido</translation>
  </message>
  <message>
   <source>{} vertex welded</source>
   <translation>{} vértice soldado</translation>
  </message>
  <message>
   <source>{} vertices added</source>
   <translation>{} vértices añadidos</translation>
  </message>
  <message>
   <source>{} vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it</source>
   <translation>{} vértices de aristas abiertas están en el lugar de otro; la superficie no está unida allí; la reparación la une</translation>
  </message>
  <message>
   <source>{} vertices welded</source>
   <translation>{} vértices soldados</translation>
  </message>
 </context>
 <context>
  <name>SourcePanel</name>
  <message>
   <source>(closed)</source>
   <translation>(cerrada)</translation>
  </message>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>A source is a line on the triangles along which rows of long, thin quads are built on both sides. Pick it in the view, or choose edges of a Part object. The maximum anisotropy says how many times longer than high the quads at the line become; it falls off with every pass.</source>
   <translation>Una fuente es una línea sobre los triángulos a cuyos lados se construyen filas de cuadriláteros largos y finos. Se elige en la vista o con aristas de un objeto Part. La anisotropía máxima dice cuántas veces más largos que altos son los cuadriláteros junto a la línea; disminuye con cada pasada.</translation>
  </message>
  <message>
   <source>Anisotropy source</source>
   <translation>Fuente de anisotropía</translation>
  </message>
  <message>
   <source>Aspect at the line</source>
   <translation>Aspecto junto a la línea</translation>
  </message>
  <message>
   <source>Click a mesh edge to start, click another to extend the line along ridges and feature lines. Double-click takes the whole line, Ctrl-click cuts it, Esc leaves.</source>
   <translation>Pulse una arista de la malla para empezar y otra para prolongar la línea por crestas y líneas características. Doble clic toma toda la línea, Ctrl-clic la corta, Esc sale.</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become; 1: a feature line without rows</source>
   <translation>Cuántas veces más largos que altos serán los cuadriláteros junto a la línea; 1: línea característica sin filas</translation>
  </message>
  <message>
   <source>Imprint: make a line that zigzags over the triangles straight before rows start</source>
   <translation>Imprimir: enderezar una línea que zigzaguea por los triángulos antes de las filas</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longitud</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Anisotropía máxima</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with its number of rows or not, e.g. 4:6, 2, 2. Empty: chosen from the maximum anisotropy</source>
   <translation>Relación de fusión de cada pasada, con su número de filas o sin él, p. ej. 4:6, 2, 2. Vacío: según la anisotropía máxima</translation>
  </message>
  <message>
   <source>Mesh edges</source>
   <translation>Aristas de la malla</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Pasadas</translation>
  </message>
  <message>
   <source>Pick a line first</source>
   <translation>Elija primero una línea</translation>
  </message>
  <message>
   <source>Pick in the view</source>
   <translation>Elegir en la vista</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Lados</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Lados de la línea, vista a lo largo con la normal hacia arriba, que reciben filas</translation>
  </message>
  <message>
   <source>Straighten zigzags</source>
   <translation>Enderezar zigzags</translation>
  </message>
  <message>
   <source>automatic</source>
   <translation>automático</translation>
  </message>
  <message>
   <source>both</source>
   <translation>ambos</translation>
  </message>
  <message>
   <source>left</source>
   <translation>izquierda</translation>
  </message>
  <message>
   <source>right</source>
   <translation>derecha</translation>
  </message>
 </context>
 <context>
  <name>Stages</name>
  <message>
   <source>Building rows</source>
   <translation>Construcción de filas</translation>
  </message>
  <message>
   <source>Checking</source>
   <translation>Comprobación</translation>
  </message>
  <message>
   <source>Cleaning up</source>
   <translation>Limpieza</translation>
  </message>
  <message>
   <source>Evening out patches</source>
   <translation>Ajuste de los trozos</translation>
  </message>
  <message>
   <source>Filling with quads</source>
   <translation>Relleno</translation>
  </message>
  <message>
   <source>Finding features</source>
   <translation>Búsqueda de aristas</translation>
  </message>
  <message>
   <source>Measuring</source>
   <translation>Medición</translation>
  </message>
  <message>
   <source>Preparing triangles</source>
   <translation>Preparación de triángulos</translation>
  </message>
  <message>
   <source>Repairing</source>
   <translation>Reparación</translation>
  </message>
  <message>
   <source>Smoothing</source>
   <translation>Suavizado</translation>
  </message>
  <message>
   <source>Triangulating</source>
   <translation>Triangulación</translation>
  </message>
  <message>
   <source>{stage} {percent} % – Esc stops it</source>
   <translation>{stage} {percent} % – Esc lo detiene</translation>
  </message>
 </context>
 <context>
  <name>SuggestPanel</name>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>Line {index}: {length}, {edges} edges</source>
   <translation>Línea {index}: {length}, {edges} aristas</translation>
  </message>
  <message>
   <source>Long, smooth ridges of the surface. OK makes a source of each that is ticked.</source>
   <translation>Crestas largas y suaves de la superficie. Aceptar hace una fuente de cada una marcada.</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Anisotropía máxima</translation>
  </message>
  <message>
   <source>No long, smooth ridge was found. Pick the line in the view instead.</source>
   <translation>No se encontró ninguna cresta larga y suave. Elija la línea en la vista.</translation>
  </message>
  <message>
   <source>Ridges of curvature and sharp edges that are long and smooth look like leading and trailing edges. Tick those that shall become sources.</source>
   <translation>Las crestas de curvatura y aristas vivas largas y suaves parecen bordes de ataque y de salida. Marque las que deban ser fuentes.</translation>
  </message>
  <message>
   <source>Suggested sources</source>
   <translation>Fuentes sugeridas</translation>
  </message>
 </context>
</TS>
