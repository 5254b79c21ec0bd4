<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>CheatSheet</name>
    <message>
        <source>Pointer</source>
        <translation>Puntero</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>sets a pin</source>
        <translation>pone un alfiler</translation>
    </message>
    <message>
        <source>Drag a pin</source>
        <translation>Arrastrar un alfiler</translation>
    </message>
    <message>
        <source>moves it; Esc puts it back</source>
        <translation>lo mueve; Esc lo devuelve a su sitio</translation>
    </message>
    <message>
        <source>Shift-click</source>
        <translation>Mayús+clic</translation>
    </message>
    <message>
        <source>selects several pins</source>
        <translation>selecciona varios alfileres</translation>
    </message>
    <message>
        <source>Digits while dragging</source>
        <translation>Cifras al arrastrar</translation>
    </message>
    <message>
        <source>set the number; Enter confirms it</source>
        <translation>fijan el valor, Intro lo acepta</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>zooms to the pointer</source>
        <translation>acerca o aleja en el puntero</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ y ]</translation>
    </message>
    <message>
        <source>size of a brush</source>
        <translation>tamaño del pincel</translation>
    </message>
    <message>
        <source>Hold H</source>
        <translation>Mantener H</translation>
    </message>
    <message>
        <source>Hold \</source>
        <translation>Mantener \</translation>
    </message>
    <message>
        <source>shows the shape before it was bent</source>
        <translation>muestra la forma sin deformar</translation>
    </message>
    <message>
        <source>X, Y, Z while dragging</source>
        <translation>X, Y, Z al arrastrar</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>bloquean un eje</translation>
    </message>
    <message>
        <source>Right or middle button</source>
        <translation>Botón derecho o central</translation>
    </message>
    <message>
        <source>turns the view; with Shift, moves it</source>
        <translation>gira la vista; con Mayús, la desplaza</translation>
    </message>
    <message>
        <source>Middle click</source>
        <translation>Clic central</translation>
    </message>
    <message>
        <source>sets the point to turn around</source>
        <translation>fija el punto en torno al que girar</translation>
    </message>
    <message>
        <source>widens it to a circle</source>
        <translation>lo ensancha en un círculo</translation>
    </message>
    <message>
        <source>Drag the ring&apos;s dot or square</source>
        <translation>Arrastrar el punto o el cuadrado del anillo</translation>
    </message>
    <message>
        <source>rotates or scales; Shift snaps to 15°</source>
        <translation>rota o escala; Mayús, en pasos de 15°</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>nudge by a pixel, with Shift by ten</source>
        <translation>desplazan un píxel; con Mayús, diez</translation>
    </message>
    <message>
        <source>pans</source>
        <translation>desplaza la vista</translation>
    </message>
    <message>
        <source>Shift-click with the brush</source>
        <translation>Mayús-clic con el pincel</translation>
    </message>
    <message>
        <source>paints a straight line</source>
        <translation>pinta una línea recta</translation>
    </message>
    <message>
        <source>Arrow keys without a pin</source>
        <translation>Teclas de flecha sin alfiler</translation>
    </message>
    <message>
        <source>move a cross, Enter clicks there</source>
        <translation>mueven una cruz, Intro hace clic allí</translation>
    </message>
    <message>
        <source>Alt-right-drag a brush</source>
        <translation>Alt y arrastrar con el botón derecho, con el pincel</translation>
    </message>
    <message>
        <source>changes its size and hardness</source>
        <translation>cambia su tamaño y su dureza</translation>
    </message>
    <message>
        <source>Tap the space bar</source>
        <translation>Pulsar la barra espaciadora</translation>
    </message>
    <message>
        <source>plays or pauses; held, it moves the view</source>
        <translation>reproduce o pausa; mantenida, mueve la vista</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Botón central</translation>
    </message>
    <message>
        <source>hides pins and overlays</source>
        <translation>oculta alfileres y superposiciones</translation>
    </message>
    <message>
        <source>Ctrl+Shift-drag a pin</source>
        <translation>Ctrl+Mayús + arrastrar un alfiler</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistas</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Arriba, Abajo</translation>
    </message>
    <message>
        <source>choose a pin</source>
        <translation>eligen un alfiler</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Izquierda, Derecha</translation>
    </message>
    <message>
        <source>show another time</source>
        <translation>muestran otro momento</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Izquierda, Alt+Derecha</translation>
    </message>
    <message>
        <source>move the chosen bars or keys</source>
        <translation>mueven las barras o claves elegidas</translation>
    </message>
    <message>
        <source>Shift-click, or a frame</source>
        <translation>Mayús+clic, o un marco</translation>
    </message>
    <message>
        <source>chooses several</source>
        <translation>elige varias</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>opens their easing curve</source>
        <translation>abre su curva de suavizado</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>copy keys, paste them at the time shown</source>
        <translation>copian claves y las pegan en el momento mostrado</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Mayús+V</translation>
    </message>
    <message>
        <source>pastes them mirrored</source>
        <translation>las pega reflejadas</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>los quita</translation>
    </message>
    <message>
        <source>I, O</source>
        <translation>I, O</translation>
    </message>
    <message>
        <source>begin and end the cycle here</source>
        <translation>empiezan y terminan aquí el ciclo</translation>
    </message>
    <message>
        <source>Shift-drag the numbers</source>
        <translation>Arrastrar los números con Mayús</translation>
    </message>
    <message>
        <source>marks the cycle</source>
        <translation>marca el ciclo</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Mayús+M</translation>
    </message>
    <message>
        <source>adds a marker</source>
        <translation>añade una marca</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>at time %1 %2 cannot go on: %3</source>
        <translation>en el tiempo %1, %2 no puede seguir: %3</translation>
    </message>
    <message>
        <source>at time %1 the shape is too stiff to settle further near %2: the steps would be too short; allow a larger tolerance</source>
        <translation>en el tiempo %1 la forma es demasiado rígida cerca de %2 para asentarse más: los pasos serían demasiado cortos; permita una tolerancia mayor</translation>
    </message>
    <message>
        <source>the shape would fold over near %1, in cell %2; move it less far or along another path, or release what holds the shape there</source>
        <translation>la forma se plegaría cerca de %1, en la celda %2; llévela menos lejos o de otro modo, o suelte lo que la sujeta allí</translation>
    </message>
    <message>
        <source>the shape would fold over near %1; move it less far or along another path, or release what holds the shape there</source>
        <translation>la forma se plegaría cerca de %1; llévela menos lejos o de otro modo, o suelte lo que la sujeta allí</translation>
    </message>
    <message>
        <source>it moves too fast near %1: the steps would be too short; give its motion more time, or allow a larger tolerance</source>
        <translation>va demasiado rápido cerca de %1, los pasos serían demasiado cortos; dé más tiempo al movimiento o permita una tolerancia mayor</translation>
    </message>
    <message>
        <source>the shape near %1 is stretched or squeezed so much that no velocity can be computed; move it less far, or make the material or the mesh more even there</source>
        <translation>la forma está tan estirada o comprimida cerca de %1 que no se puede calcular ninguna velocidad; llévela menos lejos, o haga allí más uniformes el material o la malla</translation>
    </message>
    <message>
        <source>it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time</source>
        <translation>va tan rápido cerca de %1 que los números se desbordan; llévelo menos lejos o dé más tiempo al movimiento</translation>
    </message>
    <message>
        <source>the shape needs about %1 of memory; %2 are free; fewer vertices need less</source>
        <translation>la forma necesita unos %1 de memoria; hay %2 libres; con menos vértices necesita menos</translation>
    </message>
    <message>
        <source>%1 and %2 move the point %3 in different ways at time %4</source>
        <translation>%1 y %2 mueven el punto %3 de modo distinto en el tiempo %4</translation>
    </message>
    <message>
        <source>handle &quot;%1&quot;</source>
        <translation>el alfiler «%1»</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>el alfiler %1</translation>
    </message>
    <message>
        <source>the shape</source>
        <translation>la forma</translation>
    </message>
    <message>
        <source>its region holds no vertex</source>
        <translation>su región no contiene ningún vértice</translation>
    </message>
    <message>
        <source>vertex %1 belongs to no cell</source>
        <translation>el vértice %1 no pertenece a ninguna celda</translation>
    </message>
    <message>
        <source>the picture has no alpha channel to take an outline from</source>
        <translation>la imagen no tiene canal alfa del que tomar un contorno</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>la imagen no tiene píxeles</translation>
    </message>
    <message>
        <source>no part of the picture is as large as %1 pixels</source>
        <translation>ninguna parte de la imagen llega a %1 píxeles</translation>
    </message>
    <message>
        <source>the picture is fully transparent</source>
        <translation>la imagen es totalmente transparente</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha is nowhere above the threshold of %1 %</source>
        <translation>el alfa de la imagen no supera en ningún punto el umbral de %1 %</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha has too many contours: it looks like noise</source>
        <translation>el alfa de la imagen tiene demasiados contornos: parece ruido</translation>
    </message>
    <message>
        <source>the outline is empty</source>
        <translation>el contorno está vacío</translation>
    </message>
    <message>
        <source>the outline crosses or overlaps itself near %1</source>
        <translation>el contorno se cruza o se superpone cerca de %1</translation>
    </message>
    <message>
        <source>the outline cannot be triangulated (%1)</source>
        <translation>el contorno no se puede triangular (%1)</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same, %3</source>
        <translation>los puntos %1 y %2 son el mismo, %3</translation>
    </message>
    <message>
        <source>point %1, %2, is outside the shape</source>
        <translation>el punto %1, %2, está fuera de la forma</translation>
    </message>
    <message>
        <source>an edge length of %1 would take more than %2 vertices</source>
        <translation>una longitud de arista de %1 requeriría más de %2 vértices</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>no existe</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>es una tubería, no un archivo</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>es un dispositivo, no un archivo</translation>
    </message>
    <message>
        <source>is a symbolic link that leads back to itself</source>
        <translation>es un enlace simbólico que vuelve a sí mismo</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>no se puede leer: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>no se puede escribir: %1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>puede que el disco esté lleno</translation>
    </message>
    <message>
        <source>the disk is full, only %1 are free</source>
        <translation>el disco está lleno, solo quedan %1 libres</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>la carpeta %1 no existe</translation>
    </message>
    <message>
        <source>the folder %1 is not writable</source>
        <translation>no se puede escribir en la carpeta %1</translation>
    </message>
    <message>
        <source>is read-only: make it writable first, or choose another name</source>
        <translation>es de solo lectura: hágalo antes modificable o elija otro nombre</translation>
    </message>
    <message>
        <source>is a model or a mesh of a kind that is not read (%1); these are: %2</source>
        <translation>es un modelo o una malla de un tipo que no se lee (%1); se leen: %2</translation>
    </message>
    <message>
        <source>a JPEG XL picture</source>
        <translation>una imagen JPEG XL</translation>
    </message>
    <message>
        <source>a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)</source>
        <translation>una imagen de GIMP (XCF; expórtela desde GIMP como PNG u OpenRaster)</translation>
    </message>
    <message>
        <source>has a layer &quot;%1&quot; with an opacity out of range: it is limited to 0 … 100 %</source>
        <translation>tiene una capa «%1» con una opacidad imposible: se limita a 0 … 100 %</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un documento PDF</translation>
    </message>
    <message>
        <source>a film</source>
        <translation>una película</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>un archivo ZIP</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>un archivo de texto</translation>
    </message>
    <message>
        <source>not a picture that Wend knows</source>
        <translation>una imagen que Wend no conoce</translation>
    </message>
    <message>
        <source>cannot be read as a picture: %1</source>
        <translation>no se puede leer como imagen: %1</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>no tiene píxeles</translation>
    </message>
    <message>
        <source>is a volume, not a picture</source>
        <translation>es un volumen, no una imagen</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than %3 million</source>
        <translation>tiene %1 × %2 píxeles, más de %3 millones</translation>
    </message>
    <message>
        <source>is truncated or corrupt</source>
        <translation>está truncado o dañado</translation>
    </message>
    <message>
        <source>is transparent everywhere</source>
        <translation>es transparente en todas partes</translation>
    </message>
    <message>
        <source>holds tetrahedra, but the project is in the plane</source>
        <translation>contiene tetraedros, pero el proyecto es plano</translation>
    </message>
    <message>
        <source>holds no tetrahedra, but the project is in space</source>
        <translation>no contiene tetraedros, pero el proyecto es espacial</translation>
    </message>
    <message>
        <source>the surface has no triangle</source>
        <translation>la superficie no tiene ningún triángulo</translation>
    </message>
    <message>
        <source>the surface has no extent</source>
        <translation>la superficie no tiene extensión</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>la superficie no encierra ningún volumen</translation>
    </message>
    <message>
        <source>the surface bounds no volume: %1</source>
        <translation>la superficie no delimita ningún volumen: %1</translation>
    </message>
    <message>
        <source>the surface intersects itself</source>
        <translation>la superficie se corta a sí misma</translation>
    </message>
    <message>
        <source>the surface has features too small for its size</source>
        <translation>la superficie tiene detalles demasiado finos para su tamaño</translation>
    </message>
    <message>
        <source>two facets of the surface lie almost on each other</source>
        <translation>dos facetas de la superficie están casi una sobre otra</translation>
    </message>
    <message>
        <source>the volume mesher ran out of memory</source>
        <translation>el mallador de volumen se quedó sin memoria</translation>
    </message>
    <message>
        <source>the volume mesher did not finish within %1 s of computing; a coarser quality or a larger maxVolume may help</source>
        <translation>el mallador de volumen no terminó en %1 s de cálculo; puede ayudar una calidad menor o tetraedros mayores</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>todos los puntos están en un plano</translation>
    </message>
    <message>
        <source>%1 open edge (first: %2)</source>
        <translation>%1 arista abierta (%2)</translation>
    </message>
    <message>
        <source>%1 open edges (first: %2)</source>
        <translation>%1 aristas abiertas (primera: %2)</translation>
    </message>
    <message>
        <source>%1 edge of more than two triangles (first: %2)</source>
        <translation>%1 arista de más de dos triángulos (%2)</translation>
    </message>
    <message>
        <source>%1 edges of more than two triangles (first: %2)</source>
        <translation>%1 aristas de más de dos triángulos (primera: %2)</translation>
    </message>
    <message>
        <source>%1 pair of triangles that intersect (first: %2)</source>
        <translation>%1 par de triángulos que se cortan (%2)</translation>
    </message>
    <message>
        <source>%1 pairs of triangles that intersect (first: %2)</source>
        <translation>%1 pares de triángulos que se cortan (primero: %2)</translation>
    </message>
    <message>
        <source>%1 triangle without area (first: %2)</source>
        <translation>%1 triángulo sin área (%2)</translation>
    </message>
    <message>
        <source>%1 triangles without area (first: %2)</source>
        <translation>%1 triángulos sin área (primero: %2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangle (first: %2)</source>
        <translation>%1 triángulo duplicado (%2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangles (first: %2)</source>
        <translation>%1 triángulos duplicados (primero: %2)</translation>
    </message>
    <message>
        <source>%1 edge where the orientation changes (first: %2)</source>
        <translation>%1 arista donde cambia la orientación (%2)</translation>
    </message>
    <message>
        <source>%1 edges where the orientation changes (first: %2)</source>
        <translation>%1 aristas donde cambia la orientación (primera: %2)</translation>
    </message>
    <message>
        <source>the surface was repaired: %1</source>
        <translation>la superficie se ha reparado: %1</translation>
    </message>
    <message>
        <source>%1 coincident vertex merged</source>
        <translation>%1 vértice coincidente fusionado</translation>
    </message>
    <message>
        <source>%1 coincident vertices merged</source>
        <translation>%1 vértices coincidentes fusionados</translation>
    </message>
    <message>
        <source>%1 triangle without area dropped</source>
        <translation>%1 triángulo sin área eliminado</translation>
    </message>
    <message>
        <source>%1 triangles without area dropped</source>
        <translation>%1 triángulos sin área eliminados</translation>
    </message>
    <message>
        <source>%1 duplicate triangle dropped</source>
        <translation>%1 triángulo duplicado eliminado</translation>
    </message>
    <message>
        <source>%1 duplicate triangles dropped</source>
        <translation>%1 triángulos duplicados eliminados</translation>
    </message>
    <message>
        <source>%1 triangle turned over</source>
        <translation>%1 triángulo invertido</translation>
    </message>
    <message>
        <source>%1 triangles turned over</source>
        <translation>%1 triángulos invertidos</translation>
    </message>
    <message>
        <source>%1 hole filled</source>
        <translation>%1 agujero rellenado</translation>
    </message>
    <message>
        <source>%1 holes filled</source>
        <translation>%1 agujeros rellenados</translation>
    </message>
    <message>
        <source>the surface is embedded in a cage of %1 vertices, since %2</source>
        <translation>la superficie está incrustada en una jaula de %1 vértices, porque %2</translation>
    </message>
    <message>
        <source>it cannot be meshed as it is: %1</source>
        <translation>tal como es no se puede mallar: %1</translation>
    </message>
    <message>
        <source>it has %1 vertices, where %2 were aimed at</source>
        <translation>tiene %1 vértices, cuando se pretendían %2</translation>
    </message>
    <message>
        <source>the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer</source>
        <translation>la jaula tiene %1 vértices, cuando se pretendían %2: con cubos enteros no se llega más cerca</translation>
    </message>
    <message>
        <source>the cells of the cage are larger than asked for: there is no memory for smaller ones</source>
        <translation>las celdas de la jaula son mayores de lo pedido: no hay memoria para otras menores</translation>
    </message>
    <message>
        <source>sizes are for the exact surface: a cage has cells of one size</source>
        <translation>los tamaños son para la superficie exacta: una jaula tiene celdas de un solo tamaño</translation>
    </message>
    <message>
        <source>its %1 parts share cells of the cage and move together as %2: smaller cells keep more of them apart</source>
        <translation>sus %1 partes comparten celdas de la jaula y se mueven juntas como %2: celdas menores separan más de ellas</translation>
    </message>
    <message>
        <source>the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow</source>
        <translation>la jaula está en %1 cuerpos que no están unidos: cada uno necesita su propio alfiler para seguir</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie outside the solid that carries them</source>
        <translation>%1 de %2 vértices están fuera del sólido que los lleva</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them</source>
        <translation>la malla tiene %1 vértices, cuando se pretendían %2: la calidad pedida los necesita</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is</source>
        <translation>la malla tiene %1 vértices, cuando se pretendían %2: la superficie se mantiene como es</translation>
    </message>
    <message>
        <source>the surface&apos;s triangles are far larger than the cells inside and are kept as they are, which makes uneven cells</source>
        <translation>los triángulos de la superficie son mucho mayores que las celdas interiores y se mantienen, lo que da celdas desiguales</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell is above it)</source>
        <translation>la peor celda tiene una relación radio-arista de %1, cuando se pidió %2 (%3 celda por encima)</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells are above it)</source>
        <translation>la peor celda tiene una relación radio-arista de %1, cuando se pidió %2 (%3 celdas por encima)</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2</source>
        <translation>%1: la superficie se mantiene como es y lo fuerza, en sus triángulos %2</translation>
    </message>
    <message>
        <source>%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written without them, so that later vertices have other numbers</source>
        <translation>%1 vértices de la superficie no pertenecen a ningún tetraedro: las mallas de tetraedros se escriben sin ellos y, por tanto, con otros números detrás</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 vértices no pertenecen a ninguna celda. Permanecen en lo que se escribe: algunos programas de cálculo los quieren fuera antes</translation>
    </message>
    <message>
        <source>parts that touch vertex to vertex are connected: %1 vertices move with others at the same place</source>
        <translation>las partes que se tocan vértice con vértice van unidas: %1 vértices se mueven con otros en su lugar</translation>
    </message>
    <message>
        <source>a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away unless handles hold it</source>
        <translation>una parte de %1 cuelga solo de %2 cerca de %3: lo que gira allí libremente puede salir despedido, salvo que lo sujeten alfileres</translation>
    </message>
    <message>
        <source>%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 partes cuelgan solo de un vértice o una arista, la primera, de %2, de %3 cerca de %4: lo que gira allí libremente puede salir despedido, salvo que lo sujeten alfileres</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 celdas</translation>
    </message>
    <message>
        <source>%1 cell</source>
        <translation>%1 celda</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>el vértice %1</translation>
    </message>
    <message>
        <source>the edge %1</source>
        <translation>la arista %1</translation>
    </message>
    <message>
        <source>%1 single step</source>
        <translation>%1 paso suelto</translation>
    </message>
    <message>
        <source>%1 single steps</source>
        <translation>%1 pasos sueltos</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>no hay ningún triángulo %1</translation>
    </message>
    <message>
        <source>no hole has the edge %1</source>
        <translation>ningún agujero tiene la arista %1</translation>
    </message>
    <message>
        <source>the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves together</source>
        <translation>la jaula cierra un hueco dentro de una parte, de %1 de ancho cerca de %2: lo que queda a ambos lados se mueve junto</translation>
    </message>
    <message>
        <source>the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on both sides moves together</source>
        <translation>la jaula cierra %1 huecos dentro de una parte, el más estrecho de %2 de ancho cerca de %3: lo que queda a ambos lados se mueve junto</translation>
    </message>
    <message>
        <source>%1; about %2 vertices open the widest</source>
        <translation>%1; unos %2 vértices abren el más ancho</translation>
    </message>
    <message>
        <source>%1; cells of at most %2 open the widest</source>
        <translation>%1; celdas de %2 como máximo abren el más ancho</translation>
    </message>
    <message>
        <source>%1; a detail of %2 opens the widest</source>
        <translation>%1; un detalle de %2 abre el más ancho</translation>
    </message>
    <message>
        <source>1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, so that later vertices have other numbers</source>
        <translation>1 vértice de la superficie no pertenece a ningún tetraedro: las mallas de tetraedros se escriben sin él y con otros números detrás</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 vértice no pertenece a ninguna celda. Se conserva en lo que se escribe: algunos solucionadores piden quitarlo antes</translation>
    </message>
    <message>
        <source>holds %1 points, but neither triangles nor tetrahedra between them: a surface has to be made of the points first, as MeshLab and CloudCompare do</source>
        <translation>contiene %1 puntos, pero ni triángulos ni tetraedros entre ellos: primero hay que hacer una superficie con los puntos, por ejemplo con MeshLab o CloudCompare</translation>
    </message>
    <message>
        <source>%1: its points have four coordinates; only points in space, which have three, are read</source>
        <translation>%1: sus puntos tienen cuatro coordenadas; solo se leen puntos del espacio, que tienen tres</translation>
    </message>
    <message>
        <source>the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells may help</source>
        <translation>la jaula no terminó en %1 s de cálculo; puede ayudar usar menos vértices o celdas mayores</translation>
    </message>
    <message>
        <source>there is no memory for a cage of so many cells; fewer vertices or larger cells may help</source>
        <translation>no hay memoria para una jaula de tantas celdas; puede ayudar usar menos vértices o celdas mayores</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and about %3 vertices open the widest</source>
        <translation>%1; un detalle de %2 y unos %3 vértices abren el más ancho</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and cells of at most %3 open the widest</source>
        <translation>%1; un detalle de %2 y celdas de %3 como máximo abren el más ancho</translation>
    </message>
    <message>
        <source>a list of points without a surface</source>
        <translation>una lista de puntos sin superficie</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: its outline needs them</source>
        <translation>la malla tiene %1 vértices, cuando se pretendían %2: su contorno los necesita</translation>
    </message>
    <message>
        <source>is no project of Wend, which is JSON and begins with {</source>
        <translation>no es un proyecto de Wend, que es JSON y empieza con {</translation>
    </message>
    <message>
        <source>has %1 pictures (pages, frames or parts): the first one is read</source>
        <translation>contiene %1 imágenes (páginas, fotogramas o partes): se lee la primera</translation>
    </message>
    <message>
        <source>has channels that are left out: %1</source>
        <translation>tiene canales que se omiten: %1</translation>
    </message>
    <message>
        <source>has a channel of no declared kind after its colours: it is taken as alpha</source>
        <translation>tiene tras los colores un canal de tipo no declarado: se toma como alfa</translation>
    </message>
    <message>
        <source>reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off</source>
        <translation>sobresale de su ventana de visualización de %1 x %2 píxeles: lo que queda fuera se recorta</translation>
    </message>
    <message>
        <source>has a colour profile that does not fit its colours: it is left out</source>
        <translation>tiene un perfil de color que no corresponde a sus colores: se omite</translation>
    </message>
    <message>
        <source>has a colour space that is not known (cICP %1): it is not kept</source>
        <translation>tiene un espacio de color desconocido (cICP %1): no se conserva</translation>
    </message>
    <message>
        <source>1 pixel is not a finite number (NaN or infinity), at x %1, y %2</source>
        <translation>1 píxel no es un número finito (NaN o infinito), en x %1, y %2</translation>
    </message>
    <message>
        <source>%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3</source>
        <translation>%1 píxeles no son números finitos (NaN o infinito), el primero en x %2, y %3</translation>
    </message>
    <message>
        <source>is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures</source>
        <translation>es %1. Wend abre PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, RAW de cámara y otras imágenes</translation>
    </message>
    <message>
        <source>its reader failed inside (signal %1)</source>
        <translation>el lector falló (señal %1)</translation>
    </message>
    <message>
        <source>its reader was ended (signal %1)</source>
        <translation>el lector fue terminado (señal %1)</translation>
    </message>
    <message>
        <source>its reader failed (exit code %1)</source>
        <translation>el lector falló (código de salida %1)</translation>
    </message>
    <message>
        <source>its reader has done nothing for %1 s</source>
        <translation>el lector no ha hecho nada durante %1 s</translation>
    </message>
    <message>
        <source>its reader has not come to an end</source>
        <translation>el lector no llegó a terminar</translation>
    </message>
    <message>
        <source>it needs more than the %1 MB of memory that reading may take</source>
        <translation>necesita más de los %1 MB de memoria que puede ocupar la lectura</translation>
    </message>
    <message>
        <source>has %1 layers: opened flattened</source>
        <translation>tiene %1 capas: abierto acoplado</translation>
    </message>
    <message>
        <source>holds no picture of all its layers (%1): save it with one</source>
        <translation>no contiene una imagen de todas sus capas (%1): guárdelo con ella</translation>
    </message>
    <message>
        <source>has a damaged %1</source>
        <translation>tiene dañado %1</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and %3 times more</source>
        <translation>en el tiempo %1 la forma salta a otro equilibrio cerca de %2, y %3 veces más</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2</source>
        <translation>en el tiempo %1 la forma salta a otro equilibrio cerca de %2</translation>
    </message>
    <message>
        <source>pins of the other project without a namesake here, placed in proportion: %1</source>
        <translation>alfileres del otro proyecto sin tocayo aquí, colocados en proporción: %1</translation>
    </message>
    <message>
        <source>pins of the other project that find no place here and are left out: %1</source>
        <translation>alfileres del otro proyecto que no encuentran sitio aquí y se omiten: %1</translation>
    </message>
    <message>
        <source>pins without a motion in the other project, which hold still: %1</source>
        <translation>alfileres sin movimiento en el otro proyecto, que quedan quietos: %1</translation>
    </message>
    <message>
        <source>moves a solid: its motion does not fit a picture</source>
        <translation>mueve un sólido: su movimiento no sirve para una imagen</translation>
    </message>
    <message>
        <source>moves a picture: its motion does not fit a solid</source>
        <translation>mueve una imagen: su movimiento no sirve para un sólido</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3</source>
        <translation>hay cáscaras unas dentro de otras, hasta %1 niveles; espacios llenos: %2, huecos: %3</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces filled: %2, hollow: %3</source>
        <translation>hay cáscaras unas dentro de otras, hasta %1 niveles, y cuerpos que se tocan en paredes comunes; espacios llenos: %2, huecos: %3</translation>
    </message>
    <message>
        <source>bodies touch along shared walls; spaces filled: %1, hollow: %2</source>
        <translation>hay cuerpos que se tocan en paredes comunes; espacios llenos: %1, huecos: %2</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled</source>
        <translation>%1 tiene %2 × %3 píxeles y el proyecto se hizo para %4 × %5: los alfileres y trayectorias se han escalado</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where they are</source>
        <translation>%1 tiene %2 × %3 píxeles y el proyecto se hizo para %4 × %5: los alfileres y trayectorias se quedan donde están</translation>
    </message>
    <message>
        <source>the project&apos;s picture is no SVG drawing: it has no paths that could be written</source>
        <translation>la imagen del proyecto no es un dibujo SVG: no tiene trazados que se puedan escribir</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is no SVG drawing: it becomes a picture in the SVG file</source>
        <translation>la parte «%1» no es un dibujo SVG: en el archivo SVG será una imagen</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is cut: it becomes a picture in the SVG file</source>
        <translation>la parte «%1» está recortada: en el archivo SVG será una imagen</translation>
    </message>
    <message>
        <source>its pattern &quot;%1&quot; turns and stretches with each shape, but is not bent</source>
        <translation>su motivo «%1» gira y se estira con cada forma, pero no se dobla</translation>
    </message>
    <message>
        <source>a picture in it stays one</source>
        <translation>una imagen que contiene sigue siendo una imagen</translation>
    </message>
    <message>
        <source>its picture &quot;%1&quot; is not in the file: it is left out</source>
        <translation>su imagen «%1» no está en el archivo: se omite</translation>
    </message>
    <message>
        <source>its text along a path is left out</source>
        <translation>se omite su texto a lo largo de un trazado</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; is left out</source>
        <translation>se omite su &lt;%1&gt;</translation>
    </message>
    <message>
        <source>HDF5 files need wend-hdf5, which is missing beside the program: it is built where libhdf5-dev is installed</source>
        <translation>los archivos HDF5 necesitan wend-hdf5, que falta junto al programa: se compila donde está instalado libhdf5-dev</translation>
    </message>
    <message>
        <source>the HDF5 library fails on it: the file may be damaged</source>
        <translation>la biblioteca HDF5 falla con él: puede que el archivo esté dañado</translation>
    </message>
    <message>
        <source>is no HDF5 file</source>
        <translation>no es un archivo HDF5</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both the same triangles there or leave a gap</source>
        <translation>los cuerpos %1 y %2 se tocan a lo largo de una cara cuyos triángulos no coinciden (cerca de %3): dé a ambos los mismos triángulos allí o deje un hueco</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along an edge or at a point (near %3): give both the same triangles there or leave a gap</source>
        <translation>los cuerpos %1 y %2 se tocan a lo largo de una arista o en un punto (cerca de %3): dé a ambos los mismos triángulos allí o deje un hueco</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell; it lies at the place of another and moves with it. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 vértice no pertenece a ninguna celda; coincide con otro y se mueve con él. Se conserva en lo que se escribe: algunos solucionadores piden quitarlo antes</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell; %2 of them lie at the place of another and move with it. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 vértices no pertenecen a ninguna celda; %2 de ellos coinciden con otro y se mueven con él. Permanecen en lo que se escribe: algunos programas de cálculo los quieren fuera antes</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more</source>
        <translation>%1: la superficie se mantiene como es y lo fuerza, en sus triángulos %2 y %3 más</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; has the blend mode %2: it is shown as normal</source>
        <translation>la capa «%1» tiene el modo de fusión %2: se muestra como normal</translation>
    </message>
    <message>
        <source>1 hole of %1 edges stayed open, larger than the limit of %2</source>
        <translation>1 agujero de %1 aristas quedó abierto, mayor que el límite de %2</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 edges stayed open, larger than the limit of %3</source>
        <translation>%1 agujeros de hasta %2 aristas quedaron abiertos, mayores que el límite de %3</translation>
    </message>
    <message>
        <source>1 vertex of open seams welded, the widest gap %1</source>
        <translation>1 vértice de costuras abiertas soldado, la mayor separación %1</translation>
    </message>
    <message>
        <source>%1 vertices of open seams welded, the widest gap %2</source>
        <translation>%1 vértices de costuras abiertas soldados, la mayor separación %2</translation>
    </message>
    <message>
        <source> (after the repair: %1)</source>
        <translation> (tras la reparación: %1)</translation>
    </message>
    <message>
        <source>; the repair found nothing that it could repair</source>
        <translation>; la reparación no encontró nada que pudiera reparar</translation>
    </message>
    <message>
        <source>%1 and %2 move the joint at %3 in different ways at time %4</source>
        <translation>%1 y %2 mueven la articulación en %3 de modo distinto en el tiempo %4</translation>
    </message>
    <message>
        <source>the multigrid solver did not find the velocities near %1; solve directly (--solver direct), or make the material or the mesh more even</source>
        <translation>el solucionador multimalla no halló las velocidades cerca de %1; resuelva directamente (--solver direct) o haga más uniforme el material o la malla</translation>
    </message>
    <message>
        <source>%1: its points have any number of coordinates; only points in space, which have three, are read</source>
        <translation>%1: sus puntos tienen cualquier número de coordenadas; solo se leen puntos del espacio, que tienen tres</translation>
    </message>
    <message>
        <source>%1 vertex that is not finite (first: %2)</source>
        <translation>%1 vértice no finito (%2)</translation>
    </message>
    <message>
        <source>%1 vertices that are not finite (first: %2)</source>
        <translation>%1 vértices no finitos (primero: %2)</translation>
    </message>
    <message>
        <source>%1 triangle that names a missing vertex (first: %2)</source>
        <translation>%1 triángulo que nombra un vértice inexistente (%2)</translation>
    </message>
    <message>
        <source>%1 triangles that name a missing vertex (first: %2)</source>
        <translation>%1 triángulos que nombran un vértice inexistente (primero: %2)</translation>
    </message>
    <message>
        <source>an IFF file</source>
        <translation>un archivo IFF</translation>
    </message>
    <message>
        <source>a KTX texture</source>
        <translation>una textura KTX</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>un documento PostScript</translation>
    </message>
    <message>
        <source>a PAM picture</source>
        <translation>una imagen PAM</translation>
    </message>
    <message>
        <source>a Windows cursor</source>
        <translation>un cursor de Windows</translation>
    </message>
    <message>
        <source>a QOI picture</source>
        <translation>una imagen QOI</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 2 GB, these layers have more</source>
        <translation>no se puede escribir: un archivo de Photoshop tiene como máximo 2 GB, y estas capas tienen más</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 30000 pixels a side</source>
        <translation>no se puede escribir: un archivo de Photoshop tiene como máximo 30000 píxeles por lado</translation>
    </message>
    <message>
        <source>the shape is too stiff to settle further near %1: the steps would be too short; allow a larger tolerance</source>
        <translation>la forma es demasiado rígida cerca de %1 para asentarse más: los pasos serían demasiado cortos; permita una tolerancia mayor</translation>
    </message>
    <message>
        <source>%1 cannot go on: %2</source>
        <translation>%1 no puede seguir: %2</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and once more</source>
        <translation>en el tiempo %1 la forma salta a otro equilibrio cerca de %2, y una vez más</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2</source>
        <translation>a los %1 s la forma salta a otra pose cerca de %2</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and once more</source>
        <translation>a los %1 s la forma salta a otra pose cerca de %2, y una vez más</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and %3 times more</source>
        <translation>a los %1 s la forma salta a otra pose cerca de %2, y %3 veces más</translation>
    </message>
</context>
<context>
    <name>CropTool</name>
    <message>
        <source>Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the proportions, Delete or a double-click removes it</source>
        <translation>Trace un rectángulo alrededor de lo que conservan las exportaciones; arrastre su interior o sus lados; Mayús mantiene las proporciones, Supr o un doble clic lo quita</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Double-click to insert a point into the curve</source>
        <translation>Haga doble clic para insertar un punto en la curva</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Cambiar curva</translation>
    </message>
    <message>
        <source>Insert curve point</source>
        <translation>Insertar punto de curva</translation>
    </message>
    <message>
        <source>Delete curve point</source>
        <translation>Eliminar punto de curva</translation>
    </message>
    <message>
        <source>The ends of a curve must stay.</source>
        <translation>Los extremos de una curva deben quedarse.</translation>
    </message>
    <message>
        <source>Drag the curve&apos;s point, Shift keeps it straight, Ctrl moves one direction only; Delete removes it, a right-click shows more</source>
        <translation>Arrastre el punto de la curva, en línea recta con Mayús, con Ctrl una sola dirección; Supr lo elimina, el clic derecho ofrece más</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Drag the arrow to move the cut, the rings to tilt it; Esc puts it back</source>
        <translation>Arrastre la flecha para mover el corte, los anillos para inclinarlo; Esc lo devuelve a su sitio</translation>
    </message>
</context>
<context>
    <name>DepthTool</name>
    <message>
        <source>Brush over what lies in front or behind; Ctrl clears it, Shift swaps front and back, [ and ] change the size</source>
        <translation>Pase el pincel sobre lo que quede delante o detrás; Ctrl lo anula, Mayús lo invierte, [ y ] cambian el tamaño</translation>
    </message>
    <message>
        <source>Paint in front</source>
        <translation>Pintar delante</translation>
    </message>
    <message>
        <source>Paint behind</source>
        <translation>Pintar detrás</translation>
    </message>
    <message>
        <source>Clear depth</source>
        <translation>Borrar profundidad</translation>
    </message>
</context>
<context>
    <name>EaseNames</name>
    <message>
        <source>Ease &amp;In</source>
        <translation>Suavizar &amp;entrada</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>Suavizar &amp;salida</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Suavizar &amp;ambas</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Lineal</translation>
    </message>
</context>
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Nothing grows or shrinks. Parts may get thin.</source>
        <translation>Nada crece ni encoge. Algunas partes pueden adelgazar.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Stretches least. Start here.</source>
        <translation>Estira lo mínimo. Empiece aquí.</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rígido</translation>
    </message>
    <message>
        <source>Parts turn like card.</source>
        <translation>Las partes giran como cartulina.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Details keep their look. Parts may swell.</source>
        <translation>Los detalles conservan su aspecto. Algunas partes pueden hincharse.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>ExportFormats</name>
    <message>
        <source>Layers (OpenRaster)</source>
        <translation>Capas (OpenRaster)</translation>
    </message>
    <message>
        <source>This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). Animated WebP needs no other program.</source>
        <translation>Esta película la hace el programa ffmpeg, que no está instalado (Debian: sudo apt install ffmpeg). WebP animado no necesita otro programa.</translation>
    </message>
    <message>
        <source>glTF film</source>
        <translation>Película glTF</translation>
    </message>
    <message>
        <source>Spine skeleton</source>
        <translation>Esqueleto de Spine</translation>
    </message>
    <message>
        <source>DragonBones skeleton</source>
        <translation>Esqueleto de DragonBones</translation>
    </message>
    <message>
        <source>Layers (Photoshop)</source>
        <translation>Capas (Photoshop)</translation>
    </message>
</context>
<context>
    <name>FileCard</name>
    <message>
        <source>Eyes stay round</source>
        <translation>Ojos redondos</translation>
    </message>
    <message>
        <source>Pins and paths</source>
        <translation>Trayectorias</translation>
    </message>
    <message>
        <source>Many pins at once</source>
        <translation>Varios alfileres</translation>
    </message>
    <message>
        <source>Flight, with a skin</source>
        <translation>Vuelo con piel</translation>
    </message>
    <message>
        <source>A stiff middle</source>
        <translation>Centro rígido</translation>
    </message>
    <message>
        <source>Frog</source>
        <translation>Rana</translation>
    </message>
    <message>
        <source>Giraffe</source>
        <translation>Jirafa</translation>
    </message>
    <message>
        <source>Octopus</source>
        <translation>Pulpo</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Tira</translation>
    </message>
    <message>
        <source>Eagle</source>
        <translation>Águila</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>Choose what to keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Caminante</translation>
    </message>
    <message>
        <source>A walk that loops</source>
        <translation>Un paso en bucle</translation>
    </message>
</context>
<context>
    <name>FillTool</name>
    <message>
        <source>Click to pick up what is painted there</source>
        <translation>Haga clic para tomar una muestra de lo pintado ahí</translation>
    </message>
    <message>
        <source>Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up</source>
        <translation>Haga clic para rellenar la zona contigua; Mayús rellena todo, Ctrl quita pintura, Alt toma una muestra</translation>
    </message>
    <message>
        <source>Fill with %1</source>
        <translation>Rellenar: %1</translation>
    </message>
</context>
<context>
    <name>GrabTool</name>
    <message>
        <source>Draw around the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Rodee la parte que quiera sujetar; Mayús añade a la parte seleccionada, Ctrl quita</translation>
    </message>
    <message>
        <source>Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Pase el pincel sobre la parte que quiera sujetar, [ y ] cambian el tamaño; Mayús añade, Ctrl quita</translation>
    </message>
    <message>
        <source>Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Trace un rectángulo sobre la parte que quiera sujetar; Mayús añade a la parte seleccionada, Ctrl quita</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>No part of the shape lies in this outline.</source>
        <translation>En este contorno no hay nada de la forma.</translation>
    </message>
    <message>
        <source>Select one part to take away from.</source>
        <translation>Seleccione una sola parte de la que quitar.</translation>
    </message>
    <message>
        <source>A handle must hold something; Delete removes it.</source>
        <translation>Un agarre no puede quedar vacío: elimínelo con Supr.</translation>
    </message>
</context>
<context>
    <name>GradientTool</name>
    <message>
        <source>Move gradient</source>
        <translation>Mover degradado</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Hacia %1</translation>
    </message>
    <message>
        <source>Blend to %1</source>
        <translation>Degradado hacia %1</translation>
    </message>
    <message>
        <source>Drag over the shape to blend evenly from what is there to what is chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels</source>
        <translation>Arrastre sobre la forma: lo que hay pasa gradualmente a lo elegido a la derecha; Mayús en pasos de 45°, Alt toma una muestra, Esc cancela</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Stretch</source>
        <translation>Estiramiento</translation>
    </message>
    <message>
        <source>stretch %1</source>
        <translation>estiramiento %1</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>area ×%1</source>
        <translation>área ×%1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>volume ×%1</source>
        <translation>volumen ×%1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>angle error %1</source>
        <translation>error de ángulo %1</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cizalladura</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Tamaño de celda</translation>
    </message>
    <message>
        <source>Distance from rest</source>
        <translation>Distancia al reposo</translation>
    </message>
    <message>
        <source>Influence of the pin</source>
        <translation>Influencia del alfiler</translation>
    </message>
    <message>
        <source>Stretched too far here · %1</source>
        <translation>Demasiado estirado aquí · %1</translation>
    </message>
    <message>
        <source>Grown too far here · %1</source>
        <translation>Demasiado agrandado aquí · %1</translation>
    </message>
    <message>
        <source>Shrunk too far here · %1</source>
        <translation>Demasiado encogido aquí · %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Jacobiano escalado</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Relación de aspecto</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Ángulo mínimo</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Ángulo diedro mínimo</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears</source>
        <translation>Haga clic en dos puntos para una longitud, en un tercero para el ángulo; Ctrl toma vértices, Esc borra</translation>
    </message>
    <message>
        <source>angle %1, at rest %2</source>
        <translation>ángulo %1, en reposo %2</translation>
    </message>
    <message>
        <source>length %1, at rest %2</source>
        <translation>longitud %1, en reposo %2</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Trazo</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>Det&amp;ail, in vertices</source>
        <translation>&amp;Detalle, en vértices</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation>Finura de la malla. Con más vértices la forma se curva con más suavidad, pero tarda más.</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>Cambiar detalle</translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation>&amp;Contorno</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>Cambiar contorno</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Imagen entera</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>Recorte</translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation>Polígonos trazados</translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation>Los píxeles más opacos que este valor forman parte de la forma.</translation>
    </message>
    <message>
        <source>Change what counts as solid</source>
        <translation>Cambiar umbral de opacidad</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>Mar&amp;gen</translation>
    </message>
    <message>
        <source>The outline grows by this much, so that soft edges are kept whole.</source>
        <translation>El contorno se amplía en esta medida para que los bordes suaves queden dentro por completo.</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>Cambiar margen</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Borde</translation>
    </message>
    <message>
        <source>Picture&apos;s border</source>
        <translation>Borde de la imagen</translation>
    </message>
    <message>
        <source>Holds the frame of a photograph, so that no gap opens at its edge: it stays where it is, or its sides slide along themselves. Pins on it still move.</source>
        <translation>Sujeta el marco de una foto para que no se abran huecos junto a él: se queda en su sitio o sus lados se deslizan sobre sí mismos. Los alfileres puestos en él se mueven de todos modos.</translation>
    </message>
    <message>
        <source>Hold the border</source>
        <translation>Sujetar borde</translation>
    </message>
    <message>
        <source>Moves freely</source>
        <translation>Se mueve libre</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Se queda fijo</translation>
    </message>
    <message>
        <source>Slides along itself</source>
        <translation>Se desliza sobre sí</translation>
    </message>
    <message>
        <source>Radius–edge rati&amp;o</source>
        <translation>&amp;Radio–arista</translation>
    </message>
    <message>
        <source>How flat the tetrahedra may be: the maximum ratio of circumradius to shortest edge. Smaller is rounder and takes more of them.</source>
        <translation>Lo planos que pueden ser los tetraedros: relación máxima entre circunradio y arista más corta. Cuanto menor, más redondos y más numerosos.</translation>
    </message>
    <message>
        <source>Change radius–edge ratio</source>
        <translation>Cambiar relación radio–arista</translation>
    </message>
    <message>
        <source>Ma&amp;ximum volume</source>
        <translation>Vo&amp;lumen máximo</translation>
    </message>
    <message>
        <source>Larger tetrahedra are split; in the file&apos;s units, cubed. Half the volume makes about twice as many. At a surface that is kept, some may stay larger.</source>
        <translation>Los tetraedros mayores se dividen; en unidades del archivo al cubo. Con la mitad salen aproximadamente el doble. Junto a una superficie conservada, algunos pueden quedar más grandes.</translation>
    </message>
    <message>
        <source>Change maximum volume</source>
        <translation>Cambiar volumen máximo</translation>
    </message>
    <message>
        <source>Refine s&amp;urface</source>
        <translation>Refinar s&amp;uperficie</translation>
    </message>
    <message>
        <source>Allows the surface&apos;s triangles to be split where they are larger than the tetrahedra inside. If off, the surface is kept exactly as it is.</source>
        <translation>Permite dividir los triángulos de la superficie mayores que los tetraedros interiores. Si no, la superficie se conserva tal cual.</translation>
    </message>
    <message>
        <source>Refine surface</source>
        <translation>Refinar superficie</translation>
    </message>
    <message>
        <source>Fill holes up to (edges)</source>
        <translation>Tapar huecos (aristas)</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>Hueco máximo</translation>
    </message>
    <message>
        <source>“Repair” fills holes of at most this many edges.</source>
        <translation>«Reparar» tapa los huecos de hasta este número de aristas.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>Relle&amp;no</translation>
    </message>
    <message>
        <source>What is filled: the surface itself, or a cage of even cells around it, in which it is embedded. Automatic takes the cage where the surface cannot be filled or has far too many vertices.</source>
        <translation>Qué se rellena: la propia superficie o una jaula de celdas uniformes que la rodea y la lleva consigo. Automático elige la jaula si la superficie no se puede rellenar o tiene demasiados vértices.</translation>
    </message>
    <message>
        <source>Change fit</source>
        <translation>Cambiar relleno</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Exact surface</source>
        <translation>Superficie exacta</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>Exact &amp;balance</source>
        <translation>Valor e&amp;xacto</translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation>Cambiar energía</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
    <message>
        <source>Smoothi&amp;ng length</source>
        <translation>&amp;Longitud de suavizado</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads, as a fraction of the shape&apos;s size. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation>Hasta dónde se reparte el tirón de un alfiler, en proporción al tamaño de la forma. Pequeña: junto al alfiler, marcado. Grande: amplio y suave.</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Cambiar suavizado</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>number of frames, evenly spaced from the start to the last time</source>
        <translation>número de fotogramas, a intervalos iguales del principio al final</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>&amp;Fotogramas</translation>
    </message>
    <message>
        <source>whether distortion, φ, directions and velocity are written with meshes, in formats that carry values</source>
        <translation>si la distorsión, φ, las direcciones y la velocidad acompañan a las mallas, en los formatos que admiten valores</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Valores</translation>
    </message>
    <message>
        <source>Errors, material, velocity</source>
        <translation>Errores, material, velocidad</translation>
    </message>
    <message>
        <source>The shape alone</source>
        <translation>Solo la forma</translation>
    </message>
    <message>
        <source>how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)</source>
        <translation>cómo se escriben los números en las mallas que admiten varias formas (ply, stl, msh, vtk, vtu)</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Números</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Como texto</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binario</translation>
    </message>
    <message>
        <source>Binary, compressed</source>
        <translation>Binario, comprimido</translation>
    </message>
    <message>
        <source>version of .msh files</source>
        <translation>versión de los archivos .msh</translation>
    </message>
    <message>
        <source>&amp;Gmsh version</source>
        <translation>Versión de &amp;Gmsh</translation>
    </message>
    <message>
        <source>write the triangles of a solid&apos;s border as cells too, with the values of the tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless the input had such triangles</source>
        <translation>escribir también como celdas los triángulos del borde de un sólido, con los valores de los tetraedros que hay detrás; si no, .vtu y .vtk solo contienen tetraedros, salvo que la entrada tuviera tales triángulos</translation>
    </message>
    <message>
        <source>&amp;Border triangles</source>
        <translation>&amp;Triángulos del borde</translation>
    </message>
    <message>
        <source>how the picture is sampled</source>
        <translation>cómo se muestrea la imagen</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>Fil&amp;tro</translation>
    </message>
    <message>
        <source>Nearest – hard pixels</source>
        <translation>Más cercano: píxeles duros</translation>
    </message>
    <message>
        <source>Bilinear – quick</source>
        <translation>Bilineal: rápido</translation>
    </message>
    <message>
        <source>Bicubic – sharp</source>
        <translation>Bicúbico: nítido</translation>
    </message>
    <message>
        <source>EWA – best</source>
        <translation>EWA: el mejor</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Lienzo</translation>
    </message>
    <message>
        <source>As large as the picture</source>
        <translation>Tan grande como la imagen</translation>
    </message>
    <message>
        <source>Fit to the shape</source>
        <translation>Ajustado a la forma</translation>
    </message>
    <message>
        <source>bits per channel in pictures: as in the source, 8 or 16, or half or full floating point; values stay what they are</source>
        <translation>bits por canal de las imágenes: como el original, 8 o 16, o en coma flotante, media o completa; los valores no cambian</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Bits</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Como en la imagen</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>16 bit floating point (half)</source>
        <translation>16 bits en coma flotante (half)</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 bits en coma flotante</translation>
    </message>
    <message>
        <source>what pictures show around the shape: nothing, its border drawn outwards, the source as it was, or a colour</source>
        <translation>qué muestran las imágenes junto a la forma: nada, su borde prolongado, el original tal cual o un color</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>Fon&amp;do</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparente</translation>
    </message>
    <message>
        <source>The border, drawn outwards</source>
        <translation>El borde, prolongado</translation>
    </message>
    <message>
        <source>The picture as it was</source>
        <translation>La imagen original</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>How far apart growing the outline keeps parts and limbs, so that they do not become one.</source>
        <translation>Al crecer, las partes y los miembros quedan separados así, para que no se unan.</translation>
    </message>
    <message>
        <source>Change gap</source>
        <translation>Cambiar hueco</translation>
    </message>
    <message>
        <source>Parts and holes of fewer pixels, such as dust around a drawing, are left out.</source>
        <translation>Las partes y los agujeros de menos píxeles, como el polvo alrededor de un dibujo, se omiten.</translation>
    </message>
    <message>
        <source>Change what is left out</source>
        <translation>Cambiar lo que se omite</translation>
    </message>
    <message>
        <source>&amp;Gap</source>
        <translation>&amp;Hueco</translation>
    </message>
    <message>
        <source>Drop &amp;below</source>
        <translation>Omitir &amp;bajo</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>Cambiar eje vertical</translation>
    </message>
    <message>
        <source>pixels that pictures show: those of the source, as many as the shape needs, or those of a rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it</source>
        <translation>píxeles que muestran las imágenes: los del original, tantos como necesita la forma, o los de un rectángulo X,Y,ANCHO,ALTO del original, que puede salirse de él</translation>
    </message>
    <message>
        <source>Another colour …</source>
        <translation>Otro color …</translation>
    </message>
    <message>
        <source>R&amp;ate</source>
        <translation>C&amp;adencia</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>whether WebP pictures and films keep every pixel, or are a fraction of the size with hardly visible losses</source>
        <translation>si las imágenes y películas WebP conservan cada píxel o ocupan una fracción del tamaño con pérdidas apenas visibles</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Calidad</translation>
    </message>
    <message>
        <source>Every pixel – lossless</source>
        <translation>Cada píxel – sin pérdidas</translation>
    </message>
    <message>
        <source>Smaller file – lossy</source>
        <translation>Archivo menor – con pérdidas</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Vuelve a su forma</translation>
    </message>
    <message>
        <source>Lead a pin around and back: how far does the shape come back, too? Not at all: where it ends depends on the path. Fully: it is as it was.</source>
        <translation>Un alfiler da una vuelta y regresa: ¿cuánto regresa también la forma? Nada: su final depende del camino. Del todo: queda como estaba.</translation>
    </message>
    <message>
        <source>Change springing back</source>
        <translation>Cambiar la vuelta a la forma</translation>
    </message>
    <message>
        <source>Opa&amp;que from</source>
        <translation>O&amp;paco desde</translation>
    </message>
    <message>
        <source>Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid).</source>
        <translation>Conservar como número φ, igual que en el archivo del proyecto: 0,002 conserva el área o el volumen, 0,464 la longitud, 1,571 es rígido, 2,678 conserva los ángulos (2,498 en un sólido).</translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, this with what its lines enclose, or the picture as a whole.</source>
        <translation>Lo que se dobla: solo lo opaco de la imagen, esto junto con lo que encierran sus líneas, o la imagen entera.</translation>
    </message>
    <message>
        <source>Cut-out, holes filled</source>
        <translation>Recorte, huecos rellenos</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Cambiar solucionador</translation>
    </message>
    <message>
        <source>frames per second of a film; a unit of time is a second</source>
        <translation>imágenes por segundo de una película; una unidad de tiempo es un segundo</translation>
    </message>
    <message>
        <source>Change frame rate</source>
        <translation>Cambiar la frecuencia de imágenes</translation>
    </message>
    <message>
        <source>leave the last frame out, which is the first one again: for films that repeat; if the project has a cycle, show that</source>
        <translation>omitir la última imagen, que es otra vez la primera: para películas que se repiten; si el proyecto tiene un ciclo, mostrarlo</translation>
    </message>
    <message>
        <source>Loop: no fra&amp;me twice</source>
        <translation>Bucle: ninguna imagen dos &amp;veces</translation>
    </message>
    <message>
        <source>size of pictures in percent of the canvas; that of frames becomes even</source>
        <translation>tamaño de las imágenes en porcentaje del lienzo; el de los fotogramas se hace par</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Tamaño</translation>
    </message>
    <message>
        <source>width of pictures, instead of a size in percent</source>
        <translation>anchura de las imágenes, en lugar de un tamaño en porcentaje</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Anchura</translation>
    </message>
    <message>
        <source>Inner she&amp;lls</source>
        <translation>Cáscaras in&amp;teriores</translation>
    </message>
    <message>
        <source>What is inside of shells that lie one in the other: holes, or regions of their own, whose cells are labelled. Bodies that share walls are all filled and labelled.</source>
        <translation>Qué hay dentro de cáscaras que están unas dentro de otras: huecos o regiones propias, cuyas celdas llevan etiquetas. Los cuerpos con paredes comunes se llenan y etiquetan todos.</translation>
    </message>
    <message>
        <source>Change inner shells</source>
        <translation>Cambiar cáscaras interiores</translation>
    </message>
    <message>
        <source>Holes, and say so</source>
        <translation>Huecos, con aviso</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiones</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>Draw around what should bend, too; Ctrl takes it away, Esc cancels</source>
        <translation>Rodee lo que también deba deformarse; con Ctrl se quita. Esc cancela</translation>
    </message>
    <message>
        <source>Brush over what should bend, too; Ctrl takes it away, [ and ] change the size</source>
        <translation>Pase el pincel sobre lo que también deba deformarse, [ y ] cambian el tamaño; Ctrl quita</translation>
    </message>
    <message>
        <source>Click a colour that should bend, too; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Haga clic en un color que también deba deformarse; Ctrl lo quita, [ y ] toman menos o más colores</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape; Esc cancels</source>
        <translation>Trace una línea por la que separar la forma; Esc cancela</translation>
    </message>
    <message>
        <source>Nothing would be left of the shape.</source>
        <translation>No quedaría nada de la forma.</translation>
    </message>
    <message numerus="yes">
        <source>Pins outside the new outline were removed: %n.</source>
        <translation>
            <numerusform>%n alfiler quedaba fuera del nuevo contorno y se ha eliminado.</numerusform>
            <numerusform>%n alfileres quedaban fuera del nuevo contorno y se han eliminado.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Take away from the outline</source>
        <translation>Quitar del contorno</translation>
    </message>
    <message>
        <source>Add to the outline</source>
        <translation>Añadir al contorno</translation>
    </message>
    <message>
        <source>The tolerance, or [ and ], changes what was taken; click another colour to take it too, with Ctrl to take it away</source>
        <translation>La tolerancia, también [ y ], cambia lo que se tomó; haga clic en otro color, con Ctrl se quita</translation>
    </message>
    <message>
        <source>That was a line. Draw around a part of the picture.</source>
        <translation>Eso era una línea. Rodee una parte de la imagen.</translation>
    </message>
    <message>
        <source>From now on the outline is as you draw it, and has no margin to change. Choose “Cut-out” as the outline to go back to the one that was found.</source>
        <translation>El contorno es desde ahora como usted lo dibuja y no tiene margen. «Recorte» como contorno recupera el encontrado.</translation>
    </message>
    <message>
        <source>Draw around what should bend; Ctrl takes it away, Esc cancels</source>
        <translation>Rodee lo que deba deformarse; con Ctrl se quita. Esc cancela</translation>
    </message>
    <message>
        <source>Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl takes away, Backspace removes the last corner, Esc cancels</source>
        <translation>Haga clic esquina a esquina, Mayús en pasos de 45°, el doble clic cierra; Ctrl quita, Retroceso deshace una esquina, Esc cancela</translation>
    </message>
    <message>
        <source>Brush over what should bend; Ctrl takes it away, [ and ] change the size</source>
        <translation>Pase el pincel sobre lo que deba deformarse, [ y ] cambian el tamaño; Ctrl quita</translation>
    </message>
    <message>
        <source>Click a colour that should bend; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Haga clic en un color que deba deformarse; Ctrl lo quita, [ y ] toman menos o más colores</translation>
    </message>
    <message>
        <source>Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels</source>
        <translation>Marca lo que será una parte propia, hasta donde se une al resto; Esc cancela</translation>
    </message>
    <message>
        <source>This picture has parts: choose the one in the list that this outline is for, or Make a Part to cut another one out.</source>
        <translation>Esta imagen tiene partes: elija en la lista aquella para la que es este contorno, o Crear una parte para recortar otra.</translation>
    </message>
    <message>
        <source>“%1” is locked. The list of parts unlocks it.</source>
        <translation>«%1» está bloqueada. La lista de partes la desbloquea.</translation>
    </message>
</context>
<context>
    <name>PaintTool</name>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rígido</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Combed</source>
        <translation>Peinado</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Erase paint from %1</source>
        <translation>Quitar pintura de %1</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Suavizar %1</translation>
    </message>
    <message>
        <source>Comb %1</source>
        <translation>Peinar %1</translation>
    </message>
    <message>
        <source>Paint %1 on %2</source>
        <translation>Pintar %1 en %2</translation>
    </message>
    <message>
        <source>There is no direction to follow: the numbers on the right were used.</source>
        <translation>No hay dirección que seguir: se han tomado los números de la derecha.</translation>
    </message>
    <message>
        <source>Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Peine en el sentido en que deba ser rígida; Ctrl quita, Mayús suaviza, Mayús+clic traza una línea, Alt+clic toma una muestra, Esc cancela el trazo</translation>
    </message>
    <message>
        <source>Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Pinte lo elegido a la derecha; Ctrl quita, Mayús suaviza, Mayús+clic traza una línea, Alt+clic toma una muestra, Esc cancela el trazo</translation>
    </message>
    <message>
        <source>Stiffness ×1 is the same as everywhere and changes nothing: choose on the right how many times stiffer it should be</source>
        <translation>La rigidez ×1 es como en todas partes y aquí no cambia nada: elija a la derecha cuántas veces más rígido debe ser</translation>
    </message>
    <message>
        <source>Erase paint</source>
        <translation>Quitar pintura</translation>
    </message>
    <message>
        <source>Erases paint from all visible layers: brush over what should be like the rest again; Shift-click draws a line, Esc cancels the stroke</source>
        <translation>Quita la pintura de todas las capas visibles: pase el pincel sobre lo que deba volver a ser como en todas partes; Mayús-clic traza una línea, Esc abandona el trazo</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peinar</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>Pintar %1</translation>
    </message>
    <message>
        <source>Nothing is painted there</source>
        <translation>Allí no hay nada pintado</translation>
    </message>
</context>
<context>
    <name>PanTool</name>
    <message>
        <source>Drag to move the view; the wheel zooms</source>
        <translation>Arrastre para mover la vista; la rueda acerca o aleja</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>There is nothing of the picture in this area.</source>
        <translation>En esta zona no hay nada de la imagen.</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Parte %1</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>Crear una parte</translation>
    </message>
    <message>
        <source>“%1” is a part now, joined to “%2” where it hangs on it. What is behind it is being filled.</source>
        <translation>«%1» es ahora una parte, unida a «%2» donde cuelga de ella. Lo que hay detrás se está rellenando.</translation>
    </message>
    <message>
        <source>“%1” is a part now, cut from “%2”. What is behind it is being filled. Pin it, or join it under Parts.</source>
        <translation>«%1» es ahora una parte, recortada de «%2». Lo que hay detrás se está rellenando. Fíjala o únela en Partes.</translation>
    </message>
    <message>
        <source>In this area is nothing but what is locked, if anything. The list of parts unlocks it.</source>
        <translation>En esta zona no hay más que lo bloqueado, si hay algo. La lista de partes lo desbloquea.</translation>
    </message>
    <message>
        <source>The parts are still being made. Another one can be made as soon as they are there.</source>
        <translation>Las partes aún se están haciendo. Se podrá hacer otra en cuanto estén.</translation>
    </message>
</context>
<context>
    <name>PenTool</name>
    <message>
        <source>Click the pin whose path you want to draw</source>
        <translation>Haga clic en el alfiler cuya trayectoria quiere dibujar</translation>
    </message>
    <message>
        <source>Click where the selected pin should go, point by point; drag for a smooth point</source>
        <translation>Haga clic punto por punto donde deba ir el alfiler seleccionado; arrastre para un punto suave</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, Shift snaps to 45°; Enter ends, Backspace removes the last point, Esc cancels</source>
        <translation>Clic para una esquina, arrastre para un punto suave, Mayús en pasos de 45°; Intro termina, Retroceso quita un punto, Esc abandona</translation>
    </message>
    <message>
        <source>Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only</source>
        <translation>Arrastre para un punto suave: Mayús ajusta a 45°, Ctrl o Alt mueve solo este lado</translation>
    </message>
</context>
<context>
    <name>PictureTip</name>
    <message>
        <source>near</source>
        <translation>cerca</translation>
    </message>
    <message>
        <source>far</source>
        <translation>lejos</translation>
    </message>
    <message>
        <source>×1 everywhere</source>
        <translation>×1 en todas partes</translation>
    </message>
    <message>
        <source>×50 along the left half</source>
        <translation>×50 a lo largo de la mitad izquierda</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>del todo</translation>
    </message>
    <message>
        <source>as it was pulled</source>
        <translation>tal como se tiró</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>relajada</translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag as far as the pin should hold; Esc cancels</source>
        <translation>Arrastre hasta donde el alfiler deba sujetar; Esc cancela</translation>
    </message>
    <message>
        <source>Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number</source>
        <translation>Arrastre el punto para rotar, con Mayús de 15° en 15°, o el cuadrado para escalar; las cifras fijan el valor</translation>
    </message>
    <message>
        <source>%1: holds from %2 s</source>
        <translation>%1: sujeta desde %2 s</translation>
    </message>
    <message>
        <source>%1: released at %2 s</source>
        <translation>%1: soltado en %2 s</translation>
    </message>
    <message>
        <source>Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl records it; digits set the number</source>
        <translation>Arrastre en cualquier lugar para rotar lo seleccionado, Mayús de 15° en 15°, Ctrl lo graba; los dígitos fijan el número</translation>
    </message>
    <message>
        <source>Drag anywhere to scale what is selected, Ctrl records it; digits set the number</source>
        <translation>Arrastre en cualquier lugar para escalar lo seleccionado, Ctrl lo graba; los dígitos fijan el número</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; G moves, R rotates, S scales</source>
        <translation>Arrastre una flecha, un cuadrado o un anillo; G mueve, R rota, S escala</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, draw around pins to select them</source>
        <translation>Haga clic en la forma para poner un alfiler, arrastre para deformarla al momento; fuera de ella, rodee alfileres para seleccionarlos</translation>
    </message>
    <message>
        <source>Draw around pins to select them; Shift adds, Ctrl takes away</source>
        <translation>Rodee alfileres para seleccionarlos; Mayús añade, Ctrl quita</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, brush over pins, [ and ] change the size</source>
        <translation>Haga clic en la forma para poner un alfiler, arrastre para deformarla al momento; fuera de ella, pase el pincel sobre alfileres, [ y ] cambian el tamaño</translation>
    </message>
    <message>
        <source>Brush over pins to select them, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Pase el pincel sobre alfileres para seleccionarlos, [ y ] cambian el tamaño; Mayús añade, Ctrl quita</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, or press and drag to bend it at once</source>
        <translation>Haga clic en la forma para poner un alfiler, o pulse y arrastre para deformarla al momento</translation>
    </message>
    <message>
        <source>Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move</source>
        <translation>Haga clic, o trace junto a los alfileres, para seleccionar; Mayús añade, Ctrl quita; arrastre o use las flechas para mover</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y, Z lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Mayús mantiene la línea recta; X, Y, Z bloquean un eje, los números fijan el valor, Esc restablece la forma</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Mayús mantiene la línea recta; X, Y bloquean un eje, los números fijan el valor, Esc restablece la forma</translation>
    </message>
    <message>
        <source>Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, Shift-click to select more</source>
        <translation>Arrastre para mover el alfiler, con Ctrl para grabarlo, con Ctrl+Mayús para ensancharlo; Mayús+clic selecciona más</translation>
    </message>
    <message>
        <source>Drag to scale: the point becomes a small circle</source>
        <translation>Arrastre para escalar: el punto pasa a ser un círculo pequeño</translation>
    </message>
    <message>
        <source>Drag to rotate: the point becomes a small circle, which holds its angle</source>
        <translation>Arrastre para girar: el punto pasa a ser un círculo pequeño que mantiene su ángulo</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>Choose one in the list first.</source>
        <translation>Elija primero uno de la lista.</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Recording until you let go; Esc cancels</source>
        <translation>Se graba tal cual hasta que suelte; Esc lo abandona</translation>
    </message>
</context>
<context>
    <name>RegionTool</name>
    <message>
        <source>Drag from a point on the surface to hold a ball; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Arrastre desde un punto de la superficie para sujetar una esfera; Mayús añade su contenido al agarre seleccionado, Ctrl lo quita</translation>
    </message>
    <message>
        <source>Drag from a point on the surface towards the side to hold: all that lies beyond the point</source>
        <translation>Arrastre desde un punto de la superficie hacia lo que quiera sujetar: todo lo que haya más allá del punto</translation>
    </message>
    <message>
        <source>Drag from a point on the surface to hold a box; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Arrastre desde un punto de la superficie para sujetar una caja; Mayús añade su contenido al agarre seleccionado, Ctrl lo quita</translation>
    </message>
    <message>
        <source>There is no vertex in this region.</source>
        <translation>No hay ningún vértice en esta región.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
</context>
<context>
    <name>SampleNames</name>
    <message>
        <source>back</source>
        <translation>espalda</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
    <message>
        <source>face</source>
        <translation>cara</translation>
    </message>
    <message>
        <source>far front hoof</source>
        <translation>casco delantero lejano</translation>
    </message>
    <message>
        <source>far hind hoof</source>
        <translation>casco trasero lejano</translation>
    </message>
    <message>
        <source>front hoof</source>
        <translation>casco delantero</translation>
    </message>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
    <message>
        <source>hind hoof</source>
        <translation>casco trasero</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>codo izquierdo</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>extremo izquierdo</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>ojo izquierdo</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>pie izquierdo</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>mano izquierda</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>brazo inferior izquierdo</translation>
    </message>
    <message>
        <source>left middle arm</source>
        <translation>brazo medio izquierdo</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>brazo superior izquierdo</translation>
    </message>
    <message>
        <source>left wing</source>
        <translation>ala izquierda</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>extremo derecho</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>ojo derecho</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>pie derecho</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>brazo inferior derecho</translation>
    </message>
    <message>
        <source>right middle arm</source>
        <translation>brazo medio derecho</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>brazo superior derecho</translation>
    </message>
    <message>
        <source>right wing</source>
        <translation>ala derecha</translation>
    </message>
    <message>
        <source>rump</source>
        <translation>grupa</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>hombro</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>rígido</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>cola</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>pecho</translation>
    </message>
    <message>
        <source>far hand</source>
        <translation>mano lejana</translation>
    </message>
    <message>
        <source>far heel</source>
        <translation>talón lejano</translation>
    </message>
    <message>
        <source>far toe</source>
        <translation>punta del pie lejano</translation>
    </message>
    <message>
        <source>near hand</source>
        <translation>mano cercana</translation>
    </message>
    <message>
        <source>near heel</source>
        <translation>talón cercano</translation>
    </message>
    <message>
        <source>near toe</source>
        <translation>punta del pie cercano</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>sombra</translation>
    </message>
</context>
<context>
    <name>SizeTool</name>
    <message>
        <source>Brush over what should be meshed finer; Shift makes it coarser, Ctrl evens it out again, [ and ] change the size</source>
        <translation>Pase el pincel donde la malla deba ser más fina; Mayús la hace más gruesa, Ctrl la deja uniforme, [ y ] cambian el tamaño</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>La malla procede de un archivo y se usa tal cual.</translation>
    </message>
    <message>
        <source>Paint finer mesh</source>
        <translation>Pintar malla más fina</translation>
    </message>
    <message>
        <source>Paint coarser mesh</source>
        <translation>Pintar malla más gruesa</translation>
    </message>
    <message>
        <source>Paint even mesh</source>
        <translation>Pintar malla uniforme</translation>
    </message>
</context>
<context>
    <name>StiffnessFields</name>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
</context>
<context>
    <name>StrokeTool</name>
    <message>
        <source>To the right: larger; up: harder. Esc leaves it as it was</source>
        <translation>A la derecha: más grande; arriba: más duro. Esc lo deja como estaba</translation>
    </message>
    <message>
        <source>%1 px · %2 % hard</source>
        <translation>%1 px · dureza %2 %</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Alfiler</translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation>Poner alfileres y arrastrarlos</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation>Seleccionar y arrastrar alfileres sin poner nuevos</translation>
    </message>
    <message>
        <source>Grab by &amp;Lasso</source>
        <translation>Agarrar con &amp;lazo</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a drawn outline as one handle</source>
        <translation>Sujetar como un solo agarre todo lo que haya dentro de un contorno trazado</translation>
    </message>
    <message>
        <source>Grab by Bo&amp;x</source>
        <translation>Agarrar con rectán&amp;gulo</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a rectangle as one handle</source>
        <translation>Sujetar como un solo agarre todo lo que haya dentro de un rectángulo</translation>
    </message>
    <message>
        <source>Grab by &amp;Brush</source>
        <translation>Agarrar con &amp;pincel</translation>
    </message>
    <message>
        <source>Take hold of what is brushed over as one handle</source>
        <translation>Sujetar como un solo agarre todo lo que recorra el pincel</translation>
    </message>
    <message>
        <source>Grab a B&amp;all</source>
        <translation>Agarrar una es&amp;fera</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a ball around a point on the surface</source>
        <translation>Agarrar todo lo que haya en una esfera en torno a un punto de la superficie</translation>
    </message>
    <message>
        <source>Grab a Bloc&amp;k</source>
        <translation>Agarrar una ca&amp;ja</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a block around a point on the surface</source>
        <translation>Agarrar todo lo que haya en una caja en torno a un punto de la superficie</translation>
    </message>
    <message>
        <source>Grab &amp;One Side</source>
        <translation>Agarrar u&amp;n lado</translation>
    </message>
    <message>
        <source>Take hold of all that lies beyond a plane through a point on the surface</source>
        <translation>Agarrar todo lo que haya más allá de un plano que pasa por un punto de la superficie</translation>
    </message>
    <message>
        <source>Outline by &amp;Lasso</source>
        <translation>Contorno con la&amp;zo</translation>
    </message>
    <message>
        <source>Draw around what should bend, or should not</source>
        <translation>Rodear lo que deba deformarse, o no</translation>
    </message>
    <message>
        <source>Outline by &amp;Polygon</source>
        <translation>Contorno con políg&amp;ono</translation>
    </message>
    <message>
        <source>Set the corners of what should bend, or should not</source>
        <translation>Poner las esquinas de lo que deba deformarse, o no</translation>
    </message>
    <message>
        <source>Outline by &amp;Brush</source>
        <translation>Co&amp;ntorno con pincel</translation>
    </message>
    <message>
        <source>Brush over what should bend, or should not</source>
        <translation>Pasar el pincel sobre lo que deba deformarse, o no</translation>
    </message>
    <message>
        <source>Click a colour that should bend, or should not</source>
        <translation>Hacer clic en un color que deba deformarse, o no</translation>
    </message>
    <message>
        <source>Cut &amp;Apart</source>
        <translation>Sepa&amp;rar</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape</source>
        <translation>Trazar una línea por la que se separa la forma</translation>
    </message>
    <message>
        <source>&amp;Detail Brush</source>
        <translation>Pincel de de&amp;talle</translation>
    </message>
    <message>
        <source>Brush where the mesh should be finer or coarser</source>
        <translation>Pintar dónde la malla debe ser más fina o más gruesa</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>P&amp;intar</translation>
    </message>
    <message>
        <source>Paint what is kept, or how stiff it is</source>
        <translation>Pintar qué se conserva o lo rígida que es</translation>
    </message>
    <message>
        <source>&amp;Comb</source>
        <translation>P&amp;einar</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Peinar la dirección en la que es rígida</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Degradado</translation>
    </message>
    <message>
        <source>Drag to blend evenly from what is there to what is chosen</source>
        <translation>Arrastrar: lo que hay pasa gradualmente a lo elegido</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Rellenar</translation>
    </message>
    <message>
        <source>Fill a connected area with what is chosen</source>
        <translation>Rellenar con lo elegido toda la zona contigua</translation>
    </message>
    <message>
        <source>E&amp;yedropper</source>
        <translation>C&amp;uentagotas</translation>
    </message>
    <message>
        <source>Pick up what is painted under the pointer</source>
        <translation>Tomar una muestra de lo pintado bajo el puntero</translation>
    </message>
    <message>
        <source>Depth Brus&amp;h</source>
        <translation>Pincel de pro&amp;fundidad</translation>
    </message>
    <message>
        <source>Brush over what lies in front where the shape covers itself</source>
        <translation>Pasar el pincel sobre lo que queda delante donde la forma se tapa a sí misma</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>Measure lengths and angles between points of the shape</source>
        <translation>Medir longitudes y ángulos entre puntos de la forma</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>Bo&amp;rrador</translation>
    </message>
    <message>
        <source>Erase paint: what you brush over is like the rest again</source>
        <translation>Quitar pintura: lo que recorra el pincel vuelve a ser como en todas partes</translation>
    </message>
    <message>
        <source>&amp;Crop</source>
        <translation>&amp;Recortar</translation>
    </message>
    <message>
        <source>Draw a rectangle around the part of the picture that exports keep</source>
        <translation>Trazar un rectángulo alrededor de lo que las exportaciones conservan de la imagen</translation>
    </message>
    <message>
        <source>Pe&amp;n</source>
        <translation>Pl&amp;uma</translation>
    </message>
    <message>
        <source>Draw the path of a pin, point by point</source>
        <translation>Dibujar la trayectoria de un alfiler, punto por punto</translation>
    </message>
    <message>
        <source>Pa&amp;n</source>
        <translation>Desp&amp;lazar</translation>
    </message>
    <message>
        <source>Drag the view to another place; in every step, holding the space bar does so, too</source>
        <translation>Arrastrar la vista a otro lugar; en cada paso lo hace la barra espaciadora</translation>
    </message>
    <message>
        <source>Magic &amp;Wand</source>
        <translation>&amp;Varita mágica</translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>This picture is no SVG drawing: its pixels are what it has.</source>
        <translation>Esta imagen no es un dibujo SVG: sus píxeles son los que tiene.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a picture, a mesh, a surface or a project</source>
        <translation>Abrir una imagen, una malla, una superficie o un proyecto</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Guardar el proyecto con otro nombre</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Imagen…</translation>
    </message>
    <message>
        <source>Write the bent picture at its full size</source>
        <translation>Exportar la imagen tal como está deformada, a tamaño completo</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Sequence…</source>
        <translation>&amp;Secuencia…</translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures or meshes</source>
        <translation>Exportar el movimiento como secuencia de imágenes o mallas</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation>Exportar de dónde viene cada píxel, para programas de composición</translation>
    </message>
    <message>
        <source>&amp;Mesh…</source>
        <translation>Ma&amp;lla…</translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation>Exportar la malla deformada como OBJ, PLY, VTU…</translation>
    </message>
    <message>
        <source>&amp;View…</source>
        <translation>&amp;Vista…</translation>
    </message>
    <message>
        <source>Write the view as a picture, as large as you like</source>
        <translation>Exportar la vista como imagen, del tamaño que quiera</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportar</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>C&amp;errar</translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation>Cerrar el archivo y volver a la página de inicio</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation>Salir de Wend</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>Abrir e&amp;jemplo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Deshacer el último paso</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>Rehacer lo que se deshizo</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation>Seleccionar &amp;todos los alfileres</translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation>Seleccionar todos los alfileres</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>Dese&amp;leccionar todo</translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation>No seleccionar ningún alfiler</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>Eli&amp;minar alfileres</translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation>Eliminar los alfileres seleccionados; lo que ya se movió se queda</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Colour the shape by what changed</source>
        <translation>Colorear la forma según lo que ha cambiado</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>&amp;Stiffness Marks</source>
        <translation>Marcas de &amp;rigidez</translation>
    </message>
    <message>
        <source>Show where the shape is stiff, and along which direction</source>
        <translation>Mostrar dónde es rígida y en qué dirección</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation>Mostrar la imagen sola; mantenga H para hacerlo un momento</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>Ver ori&amp;ginal</translation>
    </message>
    <message>
        <source>Show the shape as it was before it was bent; hold \ to do so for a moment</source>
        <translation>Mostrar la forma antes de deformarla; mantenga \ para hacerlo un momento</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;justar</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Mostrar toda la imagen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation>Tamaño r&amp;eal</translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation>Un píxel de la imagen por cada píxel de la pantalla</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>A&amp;cercar</translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation>Ver más de cerca</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>See more</source>
        <translation>Ver más</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>Pantalla comple&amp;ta</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Usar toda la pantalla</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Como el &amp;escritorio</translation>
    </message>
    <message>
        <source>Light or dark, like the desktop</source>
        <translation>Claro u oscuro, como el escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Oscuro sobre claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Claro sobre oscuro</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Bucle</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>Volver a empezar al final</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>Al &amp;principio</translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation>Mostrar la forma en reposo</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Al &amp;final</translation>
    </message>
    <message>
        <source>Show the end of the motion</source>
        <translation>Mostrar el final del movimiento</translation>
    </message>
    <message>
        <source>Let the shape relax at the end, with the pins where they are</source>
        <translation>Dejar que la forma se relaje hacia su reposo al final, con los alfileres donde están</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>How it works, page by page, with a search</source>
        <translation>Cómo funciona, página por página, con buscador</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Teclado y ratón</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Qué hacen el puntero y las teclas</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation>&amp;Acerca de Wend</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versión y licencia</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>Aparie&amp;ncia</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Movimiento</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Abra primero una imagen.</translation>
    </message>
    <message>
        <source>A solid has no pixels.</source>
        <translation>Un sólido no tiene píxeles.</translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation>Este proyecto no tiene imagen.</translation>
    </message>
    <message>
        <source>A solid has no pixels: export the view.</source>
        <translation>Un sólido no tiene píxeles: exporte la vista.</translation>
    </message>
    <message>
        <source>For a picture, export the picture itself.</source>
        <translation>De una imagen, exporte la propia imagen.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Seleccione primero un alfiler.</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Todavía no se mueve nada: arrastre un alfiler.</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>T&amp;utorial</translation>
    </message>
    <message>
        <source>The first five minutes, on a sample, step by step</source>
        <translation>Los primeros cinco minutos, con un ejemplo, paso a paso</translation>
    </message>
    <message>
        <source>&amp;Velocity Arrows</source>
        <translation>&amp;Flechas de velocidad</translation>
    </message>
    <message>
        <source>Show where the shape moves at this time</source>
        <translation>Mostrar hacia dónde se mueve la forma en este momento</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>&amp;Compare Energies</source>
        <translation>Comparar energía&amp;s</translation>
    </message>
    <message>
        <source>Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape</source>
        <translation>Mostrar al lado otra energía con los mismos alfileres; o arrastrar una miniatura de Conservar a la forma</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Grabar</translation>
    </message>
    <message>
        <source>Record every drag as it happens, in real time; Ctrl does so for one drag</source>
        <translation>Cada arrastre se guarda tal cual, en tiempo real; Ctrl lo hace para uno solo</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation>&amp;Papel cebolla</translation>
    </message>
    <message>
        <source>Show the shape as it was a little before and as it is a little after</source>
        <translation>Mostrar lo que hubo poco antes y lo que viene poco después</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>How fast the motion plays, and how fast time goes while drags are recorded</source>
        <translation>A qué velocidad se reproduce y con qué reloj se graba</translation>
    </message>
    <message>
        <source>Speed: %1 %</source>
        <translation>Velocidad: %1 %</translation>
    </message>
    <message>
        <source>Play or pause the motion; tapping the space bar does so, too</source>
        <translation>Reproducir el movimiento o pausarlo; también al pulsar brevemente la barra espaciadora</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>&amp;Propiedades</translation>
    </message>
    <message>
        <source>Show the properties on the right, or give their room to the shape</source>
        <translation>Mostrar las propiedades a la derecha o dejar su sitio a la forma</translation>
    </message>
    <message>
        <source>Size of M&amp;arks</source>
        <translation>Tam&amp;año de las marcas</translation>
    </message>
    <message>
        <source>How large pins, rings and curves are drawn, so that they are easy to see and to hit</source>
        <translation>El tamaño de alfileres, anillos y curvas sobre la forma, para el ojo y para la mano</translation>
    </message>
    <message>
        <source>Rela&amp;x</source>
        <translation>Re&amp;lajar</translation>
    </message>
    <message>
        <source>ST &amp;Map…</source>
        <translation>&amp;Mapa ST…</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Historial…</translation>
    </message>
    <message>
        <source>Show the undo history, and go back to any step</source>
        <translation>Mostrar el historial y volver a cualquier paso</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>Ar&amp;istas</translation>
    </message>
    <message>
        <source>Show the edges of the mesh</source>
        <translation>Mostrar las aristas de la malla</translation>
    </message>
    <message>
        <source>&amp;Colour Overlay</source>
        <translation>Superposición de &amp;color</translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Overlays</source>
        <translation>&amp;Ocultar alfileres y superposiciones</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Película…</translation>
    </message>
    <message>
        <source>Write the motion as a film: MP4, WebM, QuickTime, GIF …</source>
        <translation>Escribir el movimiento como película: MP4, WebM, QuickTime, GIF…</translation>
    </message>
    <message>
        <source>&amp;Pose at This Time</source>
        <translation>&amp;Pose en este tiempo</translation>
    </message>
    <message>
        <source>In the step Animate, a drag sets where pins are at the time shown, and what they do before and after stays; off: it leads them on to the end of the film</source>
        <translation>En el paso Animar, arrastrar fija dónde están los pines en el tiempo mostrado, y lo que hacen antes y después se conserva; desactivado: los lleva hasta el final de la película</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>Crear una &amp;parte</translation>
    </message>
    <message>
        <source>What is drawn as the outline becomes a part that bends by itself, or what you draw next; what is behind it is filled</source>
        <translation>Lo que está dibujado como contorno, o lo que dibujes ahora, será una parte que se dobla por sí sola; lo de detrás se rellena</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Keep the Pa&amp;th</source>
        <translation>Conservar el &amp;camino</translation>
    </message>
    <message>
        <source>Re&amp;place Picture…</source>
        <translation>Ree&amp;mplazar imagen…</translation>
    </message>
    <message>
        <source>Bend another picture of the same proportions in the place of this one; pins and motions stay, and are scaled if it is larger or smaller</source>
        <translation>Doblar en su lugar otra imagen de las mismas proporciones; los alfileres y movimientos se conservan y se escalan si es mayor o menor</translation>
    </message>
    <message>
        <source>&amp;Apply Motion…</source>
        <translation>&amp;Aplicar movimiento…</translation>
    </message>
    <message>
        <source>Move this shape as another project moves its own: pins of the same name, with lengths in proportion to the sizes of both shapes</source>
        <translation>Mover esta forma como otro proyecto mueve la suya: alfileres del mismo nombre, con longitudes en proporción a los tamaños de ambas formas</translation>
    </message>
    <message>
        <source>A drag that follows another of the same pins at the end of the film leads them on by a second; off: it corrects that move, which becomes straight</source>
        <translation>Un arrastre que sigue a otro de los mismos pines al final de la película los lleva un segundo más allá; desactivado: corrige ese movimiento, que pasa a ser recto</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>A&amp;tajos de teclado…</translation>
    </message>
    <message>
        <source>Give actions other keys</source>
        <translation>Dar otras teclas a las acciones</translation>
    </message>
    <message>
        <source>&amp;Drawing Size…</source>
        <translation>Tamaño del &amp;dibujo…</translation>
    </message>
    <message>
        <source>Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it</source>
        <translation>Dibujar el SVG con más o menos píxeles; los alfileres y movimientos se escalan con él</translation>
    </message>
</context>
<context>
    <name>wend::BackdropChoice</name>
    <message>
        <source>Bac&amp;kdrop</source>
        <translation>&amp;Fondo</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>&amp;Cuadros</translation>
    </message>
    <message>
        <source>Checks behind a picture, the workspace behind a solid</source>
        <translation>Cuadros detrás de una imagen, el área de trabajo detrás de un sólido</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>&amp;Blanco</translation>
    </message>
    <message>
        <source>White behind the shape, to see dark edges</source>
        <translation>Blanco detrás de la forma: se ven los bordes oscuros</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Gris</translation>
    </message>
    <message>
        <source>Grey behind the shape</source>
        <translation>Gris detrás de la forma</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Negro</translation>
    </message>
    <message>
        <source>Black behind the shape, to see light edges</source>
        <translation>Negro detrás de la forma: se ven los bordes claros</translation>
    </message>
</context>
<context>
    <name>wend::BalancePanel</name>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Este proyecto se suaviza como en el artículo, con λ; su archivo dice cuánto.</translation>
    </message>
</context>
<context>
    <name>wend::BrushActions</name>
    <message>
        <source>&amp;Brush</source>
        <translation>Pin&amp;cel</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>Pintar %1</translation>
    </message>
    <message>
        <source>Choose the step “Paint” first.</source>
        <translation>Elija antes el paso «Pintar».</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Conservar</translation>
    </message>
    <message>
        <source>Paint what the shape keeps when it has to give way</source>
        <translation>Pintar qué conserva la forma cuando tiene que ceder</translation>
    </message>
    <message>
        <source>&amp;Stiffness</source>
        <translation>&amp;Rigidez</translation>
    </message>
    <message>
        <source>Paint how many times stiffer the shape is along a direction</source>
        <translation>Pintar cuántas veces es más rígida la forma en una dirección</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Dirección</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Peinar la dirección en la que la forma es rígida</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ], or by dragging to the right with Alt and the right button.</source>
        <translation>El diámetro del pincel en pantalla; también con las teclas [ y ], o arrastrando a la derecha con Alt y el botón derecho.</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureza</translation>
    </message>
    <message>
        <source>How much of the brush paints fully; beyond that it fades out. Also by Shift with [ and ], or by dragging upwards with Alt and the right button.</source>
        <translation>Qué parte del pincel pinta del todo; más allá se difumina. También con Mayús y [ o ], o arrastrando hacia arriba con Alt y el botón derecho.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>How far a stroke goes from what is there to what is painted.</source>
        <translation>Cuánto acerca un trazo lo que hay a lo que se pinta.</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Presión</translation>
    </message>
    <message>
        <source>The harder a pen is pressed, the more of the amount is painted</source>
        <translation>Cuanto más se aprieta el lápiz, mayor es la intensidad con que se pinta</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>What you brush over lies in front if this is greater than 0, behind if it is less</source>
        <translation>Lo que recorre el pincel queda delante si es mayor que 0 y detrás si es menor</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Aristas</translation>
    </message>
    <message>
        <source>How long the mesh&apos;s edges are where you brush, compared with elsewhere</source>
        <translation>Longitud de las aristas de la malla donde pasa el pincel, respecto a las demás</translation>
    </message>
</context>
<context>
    <name>wend::CheatSheet</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
</context>
<context>
    <name>wend::CompareView</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>is being computed …</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>angle %1 · volume %2 · stretch %3</source>
        <translation>ángulo %1 · volumen %2 · estiramiento %3</translation>
    </message>
    <message>
        <source>angle %1 · area %2 · stretch %3</source>
        <translation>ángulo %1 · área %2 · estiramiento %3</translation>
    </message>
    <message>
        <source>The same with another energy</source>
        <translation>La misma forma con otra energía</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparar con</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminar la comparación</translation>
    </message>
    <message>
        <source>Shows one shape again.</source>
        <translation>Vuelve a mostrar una sola forma.</translation>
    </message>
    <message>
        <source>What this half keeps, or how it is without paint, with the same pins and motions.</source>
        <translation>Lo que conserva esta mitad, o cómo es sin pintura, con los mismos alfileres y movimientos.</translation>
    </message>
    <message>
        <source>Nothing painted</source>
        <translation>Sin pintura</translation>
    </message>
</context>
<context>
    <name>wend::CurveActions</name>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Curva</translation>
    </message>
    <message>
        <source>Edit &amp;Path</source>
        <translation>Editar tra&amp;yectoria</translation>
    </message>
    <message>
        <source>Turn the last path of the selected pin into a Bézier curve</source>
        <translation>Convertir la última trayectoria del alfiler seleccionado en una curva de Bézier</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>&amp;Insert Point</source>
        <translation>&amp;Insertar punto</translation>
    </message>
    <message>
        <source>Split the curve at the pointer, or after the chosen point; its shape stays</source>
        <translation>Dividir la curva donde se señaló o tras el punto elegido; su forma se mantiene</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>&amp;Eliminar punto</translation>
    </message>
    <message>
        <source>Remove the chosen point from the curve</source>
        <translation>Eliminar de la curva el punto elegido</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>&amp;Libre</translation>
    </message>
    <message>
        <source>Let the two directions at the point be independent</source>
        <translation>Dejar que cada dirección del punto vaya por su lado</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>&amp;Aligned</source>
        <translation>&amp;Alineado</translation>
    </message>
    <message>
        <source>Keep both directions at the point on one line</source>
        <translation>Mantener ambas direcciones del punto en una misma recta</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomático</translation>
    </message>
    <message>
        <source>Lead the curve smoothly through the point, guided by its neighbours</source>
        <translation>Llevar la curva con suavidad por el punto según sus vecinos</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>Select one pin that was dragged along a path.</source>
        <translation>Seleccione un alfiler que se haya arrastrado por una trayectoria.</translation>
    </message>
    <message>
        <source>Select one pin that follows a curve.</source>
        <translation>Seleccione un alfiler que siga una curva.</translation>
    </message>
    <message>
        <source>Click a point of the curve first; two must remain.</source>
        <translation>Haga clic primero en un punto de la curva; deben quedar dos.</translation>
    </message>
    <message>
        <source>Click an inner point of a Bézier curve first.</source>
        <translation>Haga clic primero en un punto interior de una curva de Bézier.</translation>
    </message>
</context>
<context>
    <name>wend::CurvePanel</name>
    <message>
        <source>Edit path</source>
        <translation>Editar trayectoria</translation>
    </message>
    <message>
        <source>Turns the drawn path into a Bézier curve with points to drag.</source>
        <translation>Convierte la trayectoria trazada en una curva de Bézier con puntos que se arrastran.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>as it bends (Frenet)</source>
        <translation>curvatura (Frenet)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>Rotate with path</source>
        <translation>Autoorientación</translation>
    </message>
    <message>
        <source>Whether what is held turns along the curve, and how.</source>
        <translation>Si lo sujeto gira al seguir la curva, y cómo.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsión</translation>
    </message>
    <message>
        <source>How far it turns around the curve&apos;s direction, over the whole curve.</source>
        <translation>Cuánto gira en torno a la dirección de la curva, a lo largo de toda ella.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>How large it has become at the end of the curve.</source>
        <translation>El tamaño alcanzado al final de la curva.</translation>
    </message>
    <message>
        <source>Rot&amp;ate with path</source>
        <translation>Autoo&amp;rientación</translation>
    </message>
    <message>
        <source>T&amp;wist</source>
        <translation>&amp;Torsión</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>Esca&amp;la</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow: hold more vertices.</source>
        <translation>Un punto no puede rotar ni crecer: sujete más vértices.</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Cambiar curva</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>How the motion at the shown time starts and ends.</source>
        <translation>Cómo empieza y acaba el movimiento del momento mostrado.</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Cambiar el suavizado</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow – drag its ring, or give it a radius.</source>
        <translation>Un punto no puede girar ni crecer: arrastre su anillo o dele un radio.</translation>
    </message>
</context>
<context>
    <name>wend::CutOutPanel</name>
    <message>
        <source>Only a cut-out has this. An outline that you have drawn stays as you drew it.</source>
        <translation>Solo un recorte tiene esto. Un contorno dibujado queda como lo dibujó.</translation>
    </message>
</context>
<context>
    <name>wend::CutPanel</name>
    <message>
        <source>Not cut</source>
        <translation>Sin corte</translation>
    </message>
    <message>
        <source>Whole cells</source>
        <translation>Celdas enteras</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacto</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>Corte perpendicular a %1</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Otro lado</translation>
    </message>
    <message>
        <source>Turns the plane so that it is perpendicular to this axis.</source>
        <translation>Coloca el plano perpendicular a este eje.</translation>
    </message>
    <message>
        <source>Cuts away the other side of the plane.</source>
        <translation>Quita el otro lado del plano.</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Posición del corte</translation>
    </message>
    <message>
        <source>Moves the plane through the solid.</source>
        <translation>Mueve el plano a través del sólido.</translation>
    </message>
    <message>
        <source>Normal of the cut</source>
        <translation>Normal del corte</translation>
    </message>
    <message>
        <source>The direction that the plane faces, as x, y and z.</source>
        <translation>Dirección hacia la que mira el plano, en x, y y z.</translation>
    </message>
    <message>
        <source>Distance of the cut</source>
        <translation>Distancia del corte</translation>
    </message>
    <message>
        <source>How far the plane is from the origin, along its normal.</source>
        <translation>Distancia del plano al origen, a lo largo de su normal.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>&amp;Look inside</source>
        <translation>&amp;Interior</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>Distan&amp;cia</translation>
    </message>
    <message>
        <source>There is no solid to cut yet.</source>
        <translation>Todavía no hay ningún sólido que cortar.</translation>
    </message>
    <message>
        <source>Looks inside: by whole tetrahedra, or along the exact plane.</source>
        <translation>Muestra el interior: por tetraedros enteros o por el plano exacto.</translation>
    </message>
</context>
<context>
    <name>wend::DepthActions</name>
    <message>
        <source>Bring to &amp;Front</source>
        <translation>Traer al &amp;frente</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies in front of all else</source>
        <translation>Donde la forma se tapa a sí misma, lo que rodea los alfileres seleccionados queda delante de todo lo demás</translation>
    </message>
    <message>
        <source>Ctrl+Shift+]</source>
        <translation>Ctrl+Shift+]</translation>
    </message>
    <message>
        <source>Send to &amp;Back</source>
        <translation>Enviar al f&amp;ondo</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies behind all else</source>
        <translation>Donde la forma se tapa a sí misma, lo que rodea los alfileres seleccionados queda detrás de todo lo demás</translation>
    </message>
    <message>
        <source>Ctrl+Shift+[</source>
        <translation>Ctrl+Shift+[</translation>
    </message>
    <message>
        <source>As &amp;Drawn</source>
        <translation>Como se &amp;dibujó</translation>
    </message>
    <message>
        <source>What is around the selected pins has no order of its own</source>
        <translation>Lo que rodea los alfileres seleccionados no tiene orden propio</translation>
    </message>
    <message>
        <source>&amp;Number…</source>
        <translation>&amp;Número…</translation>
    </message>
    <message>
        <source>Give what is around the selected pins an order: the greater number lies in front</source>
        <translation>Dar un orden a lo que rodea los alfileres seleccionados: el mayor queda delante</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Profundidad</translation>
    </message>
    <message>
        <source>A solid has depth of its own.</source>
        <translation>Un sólido ya tiene su profundidad.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Seleccione primero un alfiler.</translation>
    </message>
    <message>
        <source>Bring to front</source>
        <translation>Traer al frente</translation>
    </message>
    <message>
        <source>Send to back</source>
        <translation>Enviar al fondo</translation>
    </message>
    <message>
        <source>Depth as drawn</source>
        <translation>Profundidad original</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Order (in front: greater than 0, behind: less):</source>
        <translation>Orden (delante: mayor que 0, detrás: menor):</translation>
    </message>
</context>
<context>
    <name>wend::DetailChooser</name>
    <message>
        <source>Choose Skin</source>
        <translation>Elegir piel</translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Superficies (%1)</translation>
    </message>
    <message>
        <source>This surface cannot be embedded in the solid. %1</source>
        <translation>Esta superficie no puede seguir al sólido. %1</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Elegir piel</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Eliminar piel</translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Go to the worst place</source>
        <translation>Ir al peor punto</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Qué ha cambiado</translation>
    </message>
    <message>
        <source>Colour &amp;by</source>
        <translation>C&amp;olor según</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>Error de ángulo</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation>Suma sobre la forma de σ₁/σ₂ + σ₂/σ₁ − 2: cero si se conservan todos los ángulos.</translation>
    </message>
    <message>
        <source>Area error</source>
        <translation>Error de área</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramiento</translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation>Cuánto se apartan las longitudes de las del reposo: cero en un movimiento rígido.</translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation>Peor punto</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>Error de volumen</translation>
    </message>
    <message>
        <source>Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.</source>
        <translation>Suma sobre la forma de det F + 1/det F − 2: cero si se conservan todos los volúmenes.</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation>Suma sobre la forma de σ₁σ₂ + 1/(σ₁σ₂) − 2: cero si se conservan todas las áreas.</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Color según</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>Opac&amp;idad</translation>
    </message>
    <message>
        <source>What is coloured over the solid: the error of lengths, volumes or angles, how far it is from where it was, the material, how fast it moves, or how fine its mesh is.</source>
        <translation>Qué se colorea sobre el sólido: el error de longitudes, volúmenes o ángulos, la distancia a su lugar original, el material, la velocidad con que se mueve o lo fina que es su malla.</translation>
    </message>
    <message>
        <source>What is coloured over the picture: the error of lengths, areas or angles, how far it is from where it was, the material, or how fast it moves.</source>
        <translation>Qué se colorea sobre la imagen: el error de longitudes, áreas o ángulos, la distancia a su lugar original, el material o la velocidad con que se mueve.</translation>
    </message>
    <message>
        <source>Smooth colo&amp;urs</source>
        <translation>Colores s&amp;uaves</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>Degenerados</translation>
    </message>
    <message>
        <source>Passes through itself</source>
        <translation>Se atraviesa</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>Se cruza</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>en ningún lugar</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 lugar</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n lugar</numerusform>
            <numerusform>%n lugares</numerusform>
        </translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 celda</translation>
    </message>
    <message numerus="yes">
        <source>%n cells</source>
        <translation>
            <numerusform>%n celda</numerusform>
            <numerusform>%n celdas</numerusform>
        </translation>
    </message>
    <message>
        <source>This is checked once the pose is at rest.</source>
        <translation>Se busca en cuanto la pose está en reposo.</translation>
    </message>
    <message>
        <source>There is no such place.</source>
        <translation>No hay ningún lugar así.</translation>
    </message>
    <message>
        <source>No place is farther from rest than another.</source>
        <translation>Ningún lugar está más lejos del reposo que otro.</translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation>Error de alfiler</translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation>Cuánto se aparta el peor alfiler de su sitio</translation>
    </message>
    <message>
        <source>Computing time</source>
        <translation>Tiempo de cálculo</translation>
    </message>
    <message>
        <source>How long the shown shape took to compute</source>
        <translation>Cuánto tardó en calcularse la forma mostrada</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Lock the scale</source>
        <translation>Bloquear la escala</translation>
    </message>
    <message>
        <source>How much the overlay covers the picture, or the colours of the solid, below it.</source>
        <translation>Cuánto cubre la superposición la imagen, o los colores del sólido, que hay debajo.</translation>
    </message>
    <message>
        <source>Blends the colours of the overlay from cell to cell. If off, each cell has the one colour of its value.</source>
        <translation>Hace que los colores de la superposición pasen gradualmente de celda a celda. Si no, cada celda tiene el único color de su valor.</translation>
    </message>
    <message>
        <source>Keeps the range of the colours, to compare different shapes and energies.</source>
        <translation>Mantiene el rango de los colores, para comparar formas y energías.</translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the overlay.</source>
        <translation>Lleva a la vista el triángulo más deformado; la superposición lo rodea con un anillo.</translation>
    </message>
    <message>
        <source>The tetrahedron that is farthest from rest in what the overlay shows.</source>
        <translation>El tetraedro más alejado del reposo según lo que muestra la superposición.</translation>
    </message>
    <message>
        <source>The triangle that is farthest from rest in what the overlay shows.</source>
        <translation>El triángulo más alejado del reposo según lo que muestra la superposición.</translation>
    </message>
    <message>
        <source>In how many places the surface passes through itself once the pose is at rest, each with its pairs of triangles. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Cuántas veces la superficie se atraviesa cuando la pose está quieta: lugares, cada uno de pares de triángulos. Un clic muestra el siguiente; la superposición los marca en rojo.</translation>
    </message>
    <message>
        <source>Where the outline crosses itself once the pose is at rest: one part lies over another. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Dónde el contorno se cruza cuando la pose está quieta: una parte queda sobre otra. Un clic muestra el lugar siguiente; la superposición los marca en rojo.</translation>
    </message>
    <message>
        <source>Tetrahedra with more than ten times their volume, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Tetraedros de más de diez veces su volumen, o de menos de una décima parte. Un clic muestra el lugar siguiente; la superposición los marca en rojo.</translation>
    </message>
    <message>
        <source>Triangles with more than ten times their area, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Triángulos de más de diez veces su área, o de menos de una décima parte. Un clic muestra el lugar siguiente; la superposición los marca en rojo.</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarítmica</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Colores desde</translation>
    </message>
    <message>
        <source>The value of the first colour. A typed value locks the scale; “≤” in the legend says that some places have less.</source>
        <translation>El valor del primer color. Un valor escrito fija la escala; «≤» en la leyenda dice que hay lugares con menos.</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>Colores hasta</translation>
    </message>
    <message>
        <source>The value of the last colour. A typed value locks the scale; “≥” in the legend says that some places have more.</source>
        <translation>El valor del último color. Un valor escrito fija la escala; «≥» en la leyenda dice que hay lugares con más.</translation>
    </message>
    <message>
        <source>Spreads the colours evenly over the orders of magnitude of the values.</source>
        <translation>Reparte los colores por igual entre los órdenes de magnitud de los valores.</translation>
    </message>
    <message>
        <source>Colours from, to</source>
        <translation>Colores desde, hasta</translation>
    </message>
    <message>
        <source>These colours are those of the four energies.</source>
        <translation>Estos colores son los de las cuatro energías.</translation>
    </message>
    <message>
        <source>The scale of this measure is fixed.</source>
        <translation>La escala de esta medida es fija.</translation>
    </message>
</context>
<context>
    <name>wend::DrawingSizeDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Drawing Size</source>
        <translation>Tamaño del dibujo</translation>
    </message>
    <message>
        <source>The drawing becomes a picture of this size. Pins, paths and regions are scaled with it; exported SVG files keep the drawing&apos;s own units.</source>
        <translation>El dibujo se convierte en una imagen de este tamaño. Alfileres, trayectorias y regiones se escalan con él; los archivos SVG exportados conservan las unidades del dibujo.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Anchura</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>Alt&amp;ura</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>E&amp;scala</translation>
    </message>
    <message>
        <source>Of the size at which the drawing is opened</source>
        <translation>Del tamaño con el que se abre el dibujo</translation>
    </message>
</context>
<context>
    <name>wend::EaseEditor</name>
    <message>
        <source>Easing Curve</source>
        <translation>Curva de suavizado</translation>
    </message>
    <message>
        <source>Speed at the &amp;start</source>
        <translation>Velocidad al &amp;principio</translation>
    </message>
    <message>
        <source>Speed at the &amp;end</source>
        <translation>Velocidad al &amp;final</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>In percent of the speed of an even move: at 0 % the pin stops there.</source>
        <translation>En porcentaje de la velocidad de un movimiento uniforme: con 0 % el alfiler se detiene ahí.</translation>
    </message>
    <message>
        <source>Speed at the start</source>
        <translation>Velocidad al principio</translation>
    </message>
    <message>
        <source>Speed at the end</source>
        <translation>Velocidad al final</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Mantener</translation>
    </message>
    <message>
        <source>The pin stays where it was, and goes on from there afterwards.</source>
        <translation>El alfiler se queda donde estaba y después sigue desde ahí.</translation>
    </message>
    <message>
        <source>Choose a bar or a key in the tracks.</source>
        <translation>Elija una barra o una clave en las pistas.</translation>
    </message>
    <message>
        <source>Rotations and scalings have one of the four easings.</source>
        <translation>Los giros y escalados tienen uno de los cuatro suavizados.</translation>
    </message>
    <message>
        <source>1 motion</source>
        <translation>1 movimiento</translation>
    </message>
    <message numerus="yes">
        <source>%n motions</source>
        <translation>
            <numerusform>%n movimiento</numerusform>
            <numerusform>%n movimientos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::EasePlot</name>
    <message>
        <source>Easing curve</source>
        <translation>Curva de suavizado</translation>
    </message>
    <message>
        <source>How far the pin has come over time. Drag the two handles up or down; Left and Right choose one, Up and Down move it.</source>
        <translation>Hasta dónde ha llegado el alfiler a lo largo del tiempo. Arrastre las dos asas arriba o abajo; Izquierda y Derecha eligen una, Arriba y Abajo la mueven.</translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>What the shape keeps where it has to give way: from its volume, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Qué conserva la forma donde tiene que ceder: desde su volumen, pasando por las longitudes y las partes rígidas, hasta el aspecto de sus detalles. Entre dos nombres hay algo de ambos.</translation>
    </message>
    <message>
        <source>What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Qué conserva la forma donde tiene que ceder: desde su área, pasando por las longitudes y las partes rígidas, hasta el aspecto de sus detalles. Entre dos nombres hay algo de ambos.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
</context>
<context>
    <name>wend::ExportDialog</name>
    <message>
        <source>Export Picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>Export Sequence</source>
        <translation>Exportar secuencia</translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation>Exportar mapa ST</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Exportar malla</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Exportar película</translation>
    </message>
</context>
<context>
    <name>wend::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>El tipo de archivo que se exporta.</translation>
    </message>
    <message>
        <source>Fit the Can&amp;vas</source>
        <translation>A&amp;justar el lienzo</translation>
    </message>
    <message>
        <source>Fit the canvas</source>
        <translation>Ajustar el lienzo</translation>
    </message>
    <message>
        <source>Make the canvas as large as the shape needs, so that nothing is cut off.</source>
        <translation>Dar al lienzo el tamaño que la forma necesita, para que no se corte nada.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormato</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Como en la imagen</translation>
    </message>
    <message>
        <source>As it suits the format best</source>
        <translation>Lo mejor que permita el formato</translation>
    </message>
    <message>
        <source>%1 px on the left</source>
        <translation>%1 px a la izquierda</translation>
    </message>
    <message>
        <source>%1 px at the top</source>
        <translation>%1 px arriba</translation>
    </message>
    <message>
        <source>%1 px on the right</source>
        <translation>%1 px a la derecha</translation>
    </message>
    <message>
        <source>%1 px at the bottom</source>
        <translation>%1 px abajo</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>As it moves, the shape leaves the picture and is cut off there: %1.</source>
        <translation>En su recorrido, la forma sale de la imagen y ahí se corta: %1.</translation>
    </message>
    <message>
        <source>The shape reaches beyond the picture and is cut off there: %1.</source>
        <translation>La forma sobresale de la imagen y ahí se corta: %1.</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 vértices</translation>
    </message>
    <message numerus="yes">
        <source>%n shapes of %1</source>
        <translation>
            <numerusform>%n forma de %1</numerusform>
            <numerusform>%n formas de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures of %1</source>
        <translation>
            <numerusform>%n imagen de %1</numerusform>
            <numerusform>%n imágenes de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Recortado</translation>
    </message>
    <message>
        <source>%1 has no transparency: pictures are placed on white.</source>
        <translation>%1 no tiene transparencia: las imágenes se ponen sobre blanco.</translation>
    </message>
</context>
<context>
    <name>wend::ExportPanel</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Secuencia</translation>
    </message>
    <message>
        <source>ST Map</source>
        <translation>Mapa ST</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Choose a name and write what the preview shows.</source>
        <translation>Elegir un nombre y escribir lo que muestra la vista previa.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
</context>
<context>
    <name>wend::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>What will be written, smaller</source>
        <translation>Lo que se exportará, más pequeño</translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>Writing the picture …</source>
        <translation>Exportando la imagen…</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n frames …</source>
        <translation>
            <numerusform>Exportando %n fotograma…</numerusform>
            <numerusform>Exportando %n fotogramas…</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation>Exportando la malla…</translation>
    </message>
    <message>
        <source>“%1” is this project itself. Replace it?</source>
        <translation>«%1» es este mismo proyecto. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>“%1” is the picture that this project bends. Replace it?</source>
        <translation>«%1» es la imagen que este proyecto deforma. ¿Reemplazarla?</translation>
    </message>
    <message>
        <source>“%1” is the mesh that this project bends. Replace it?</source>
        <translation>«%1» es la malla que este proyecto deforma. ¿Reemplazarla?</translation>
    </message>
    <message>
        <source>“%1” belongs to this project. Replace it?</source>
        <translation>«%1» forma parte de este proyecto. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Another export is still being written. Try again in a moment.</source>
        <translation>Aún hay otra exportación en curso. Vuelva a intentarlo en un momento.</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>La forma aún se está calculando. Vuelva a intentarlo en un momento.</translation>
    </message>
    <message>
        <source>There is no shape to export: it could not be computed.</source>
        <translation>No hay forma que exportar: no se ha podido calcular.</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message numerus="yes">
        <source>Replace the frames that already exist (%n)?</source>
        <translation>
            <numerusform>%n de estos fotogramas ya existe. ¿Reemplazarlo?</numerusform>
            <numerusform>%n de estos fotogramas ya existen. ¿Reemplazarlos?</numerusform>
        </translation>
    </message>
    <message>
        <source>What it holds now will be lost, and the project will no longer open as it is.</source>
        <translation>Su contenido actual se perderá y el proyecto ya no se abrirá como está ahora.</translation>
    </message>
    <message>
        <source>What they hold now will be lost.</source>
        <translation>Su contenido actual se perderá.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>No se ha exportado nada. %1</translation>
    </message>
    <message>
        <source>Written without velocities: %1 (%2)</source>
        <translation>Exportado sin velocidades: %1 (%2)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Exportado: %1</translation>
    </message>
    <message>
        <source>Export Material</source>
        <translation>Exportar material</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Imágenes (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Writing the ST map …</source>
        <translation>Exportando el mapa ST…</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Escribiendo la película…</translation>
    </message>
</context>
<context>
    <name>wend::FactsPanel</name>
    <message>
        <source>size</source>
        <translation>tamaño</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triángulos</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>aristas</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>mean edge</source>
        <translation>arista media</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>partes</translation>
    </message>
    <message>
        <source>boundary loops</source>
        <translation>bucles de borde</translation>
    </message>
    <message>
        <source>genus</source>
        <translation>género</translation>
    </message>
    <message>
        <source>crossing pairs</source>
        <translation>pares que se cruzan</translation>
    </message>
    <message>
        <source>Worst cell</source>
        <translation>Peor celda</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>Siguiente hueco</translation>
    </message>
    <message>
        <source>Open the widest</source>
        <translation>Abrir el más ancho</translation>
    </message>
    <message>
        <source>Facts of the file</source>
        <translation>Datos del archivo</translation>
    </message>
    <message>
        <source>The surface as it is in its file. Lengths are in the file&apos;s units, which few files name.</source>
        <translation>La superficie tal como está en el archivo. Las longitudes están en la unidad del archivo, que pocos indican.</translation>
    </message>
    <message>
        <source>Quality of the cells</source>
        <translation>Calidad de las celdas</translation>
    </message>
    <message>
        <source>Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are above that, and how many triangles of the surface force them.</source>
        <translation>Radio circunscrito entre la arista más corta del peor tetraedro, lo pedido, cuántos lo superan y cuántos triángulos de la superficie los imponen.</translation>
    </message>
    <message>
        <source>Closed gaps</source>
        <translation>Huecos cerrados</translation>
    </message>
    <message>
        <source>Gaps within one part that the cage closes: what lies on both sides moves together.</source>
        <translation>Huecos en una misma parte que la jaula cierra: ambos lados se mueven juntos.</translation>
    </message>
    <message>
        <source>Goes to the tetrahedron with the largest ratio.</source>
        <translation>Mira el tetraedro con la mayor razón.</translation>
    </message>
    <message>
        <source>Goes through the gaps that the cage closes, one after another.</source>
        <translation>Mira uno tras otro los huecos que cierra la jaula.</translation>
    </message>
    <message>
        <source>Makes the cage so fine that the widest of these gaps stays open.</source>
        <translation>Afina la jaula para que el más ancho de estos huecos quede abierto.</translation>
    </message>
    <message>
        <source>Looking at the file …</source>
        <translation>Se examina el archivo…</translation>
    </message>
    <message>
        <source>Surface of the file</source>
        <translation>Superficie del archivo</translation>
    </message>
    <message>
        <source>worst ratio</source>
        <translation>peor razón</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>pedida</translation>
    </message>
    <message>
        <source>cells above</source>
        <translation>celdas por encima</translation>
    </message>
    <message>
        <source>forced by triangles</source>
        <translation>impuesto por triángulos</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedros</translation>
    </message>
    <message>
        <source>That would take more than a million vertices.</source>
        <translation>Harían falta más de un millón de vértices.</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>closed gaps</source>
        <translation>huecos cerrados</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>el más estrecho</translation>
    </message>
    <message>
        <source>Open a gap</source>
        <translation>Abrir un hueco</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>caras</translation>
    </message>
</context>
<context>
    <name>wend::FileCard</name>
    <message>
        <source>Sample: %1</source>
        <translation>Ejemplo: %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation>Abrir el ejemplo «%1»</translation>
    </message>
    <message>
        <source>%1, solid</source>
        <translation>%1, sólido</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Sólido</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>Recuperar %1</translation>
    </message>
    <message>
        <source>Open the unsaved changes to “%1”</source>
        <translation>Abrir los cambios sin guardar de «%1»</translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation>Todo lo que abre Wend (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Proyectos (*.wend)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Mallas (%1)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>%1 has moved.</source>
        <translation>%1 ya no está en su sitio.</translation>
    </message>
    <message>
        <source>Find It…</source>
        <translation>Buscar…</translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation>No se puede abrir este archivo. %1</translation>
    </message>
    <message>
        <source>Nothing to see in this picture.</source>
        <translation>No hay nada visible en esta imagen.</translation>
    </message>
    <message>
        <source>Use Whole Frame</source>
        <translation>Usar imagen entera</translation>
    </message>
    <message>
        <source>Open Another…</source>
        <translation>Abrir otra…</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Todos los archivos</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>Buscar %1</translation>
    </message>
    <message>
        <source>Your changes cannot be recovered if the program crashes: please save. %1</source>
        <translation>No hay copia de sus cambios por si el programa falla: guárdelos. %1</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>“%1” was changed by another program or window.</source>
        <translation>Otro programa u otra ventana ha modificado «%1».</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar el mío</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>¿Recargar «%1»?</translation>
    </message>
    <message>
        <source>Your changes since it was saved will be lost.</source>
        <translation>Se perderán los cambios que ha hecho desde que se guardó.</translation>
    </message>
    <message>
        <source>Saving replaces those changes; reloading discards yours.</source>
        <translation>Guardar reemplaza esos cambios; recargar descarta los suyos.</translation>
    </message>
    <message>
        <source>The project was not saved: it needs the file “%1” itself. Choose another name.</source>
        <translation>No se ha guardado el proyecto: necesita el propio archivo «%1». Elija otro nombre.</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation>No se ha guardado el proyecto. %1</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>If you do not save, they will be lost.</source>
        <translation>Si no los guarda, se perderán.</translation>
    </message>
    <message>
        <source>Wend was not closed properly: there are unsaved changes to “%1”.</source>
        <translation>Wend no se cerró correctamente: hay cambios sin guardar de «%1».</translation>
    </message>
    <message>
        <source>Discard the unsaved changes to “%1”? They cannot be brought back.</source>
        <translation>¿Descartar los cambios sin guardar de «%1»? No se podrán recuperar.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save what you made of “%1”?</source>
        <translation>¿Guardar lo que ha hecho con «%1»?</translation>
    </message>
    <message>
        <source>It becomes a project of its own; the file stays as it is. If you do not save, what you made will be lost.</source>
        <translation>Se convierte en un proyecto propio; el archivo queda como está. Si no lo guarda, lo hecho se perderá.</translation>
    </message>
    <message>
        <source>“%1” %2.</source>
        <comment>a file, and what is wrong with it</comment>
        <translation>«%1» %2.</translation>
    </message>
    <message>
        <source>Pictures with layers (%1)</source>
        <translation>Imágenes con capas (%1)</translation>
    </message>
</context>
<context>
    <name>wend::FilmPanel</name>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Choose sound</source>
        <translation>Elegir sonido</translation>
    </message>
    <message>
        <source>A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films.</source>
        <translation>Un archivo cuyo sonido empieza con el movimiento y pasa a las películas MP4, WebM y QuickTime.</translation>
    </message>
    <message>
        <source>Remove sound</source>
        <translation>Quitar el sonido</translation>
    </message>
    <message>
        <source>The film has no sound then.</source>
        <translation>Entonces la película no tiene sonido.</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Sonido</translation>
    </message>
    <message>
        <source>The part of the film that repeats, in seconds. A film that is exported as a loop shows it, and no picture twice.</source>
        <translation>La parte de la película que se repite, en segundos. Una película exportada como bucle la muestra, y ninguna imagen dos veces.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Cambiar el ciclo</translation>
    </message>
    <message>
        <source>Choose Sound</source>
        <translation>Elegir sonido</translation>
    </message>
    <message>
        <source>Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</source>
        <translation>Sonido y películas (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</translation>
    </message>
</context>
<context>
    <name>wend::FlowPanel</name>
    <message>
        <source>Relax</source>
        <translation>Relajar</translation>
    </message>
    <message>
        <source>The pins stay where they are, and what lies between them releases its tension. This takes one second at the end of the film.</source>
        <translation>Los alfileres quedan donde están y lo que hay entre ellos suelta su tensión. Ocupa un segundo al final de la película.</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Vuelve a su forma</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>Todavía no se ha movido nada.</translation>
    </message>
    <message>
        <source>A shape that springs back fully is always relaxed.</source>
        <translation>Una forma que se recupera del todo está siempre relajada.</translation>
    </message>
</context>
<context>
    <name>wend::GroupList</name>
    <message>
        <source>Hold It</source>
        <translation>Sujetarlo</translation>
    </message>
    <message>
        <source>Groups of the file</source>
        <translation>Grupos del archivo</translation>
    </message>
    <message>
        <source>What the mesh&apos;s file calls by a name or number. A click marks a group on the shape; a double click, or Enter, pins it.</source>
        <translation>Lo que el archivo de la malla llama por un nombre o número. Un clic marca un grupo en la forma; un doble clic o Intro lo fija con un alfiler.</translation>
    </message>
    <message>
        <source>Hold the group</source>
        <translation>Sujetar el grupo</translation>
    </message>
    <message>
        <source>Makes a pin of the chosen group, which the project names, so that it fits other meshes, too.</source>
        <translation>Hace un alfiler del grupo elegido. El proyecto guarda su nombre, de modo que sirve también para otras mallas.</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vértices</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>líneas</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>superficies</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>volúmenes</translation>
    </message>
    <message>
        <source>%1 (%2 %3)</source>
        <comment>name, number and kind of cells</comment>
        <translation>%1 (%2 %3)</translation>
    </message>
</context>
<context>
    <name>wend::HandlePanel</name>
    <message>
        <source>Select a pin to see its numbers.</source>
        <translation>Seleccione un alfiler para ver sus valores.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Rotar</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Exact step</source>
        <translation>Paso exacto</translation>
    </message>
    <message>
        <source>Moves, rotates or scales what is selected by exact numbers.</source>
        <translation>Mueve, rota o escala la selección con valores exactos.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>How far along x, y and z; an angle; or a factor.</source>
        <translation>La distancia en x, y y z, un ángulo o un factor.</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>eje X</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>eje Y</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>eje Z</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>The axis of the rotation, through the middle of what is selected.</source>
        <translation>El eje de giro, por el centro de la selección.</translation>
    </message>
    <message>
        <source>Applies this step; it becomes part of the motion.</source>
        <translation>Ejecuta este paso; pasa a formar parte del movimiento.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Alfiler</translation>
    </message>
    <message>
        <source>at %1, %2, %3</source>
        <translation>en %1, %2, %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>en %1; %2</translation>
    </message>
    <message>
        <source>does not hold now</source>
        <translation>no sujeta ahora</translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>wend::KeyPoseStrip</name>
    <message>
        <source>Key poses</source>
        <translation>Poses clave</translation>
    </message>
    <message>
        <source>The shape at the key poses of all pins: a click goes there</source>
        <translation>La forma en las poses clave de todos los alfileres: un clic va allí</translation>
    </message>
    <message>
        <source>Key pose at %1</source>
        <translation>Pose clave: %1</translation>
    </message>
</context>
<context>
    <name>wend::LanguageChoice</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Como el &amp;escritorio</translation>
    </message>
    <message>
        <source>Speak the desktop&apos;s language, if Wend knows it</source>
        <translation>Hablar el idioma del escritorio, si Wend lo conoce</translation>
    </message>
    <message>
        <source>Speak %1</source>
        <translation>Hablar %1</translation>
    </message>
    <message>
        <source>The language of the window, from the next start of Wend</source>
        <translation>El idioma de la ventana, desde el próximo inicio de Wend</translation>
    </message>
    <message>
        <source>The language changes when Wend starts the next time.</source>
        <translation>El idioma cambiará la próxima vez que se inicie Wend.</translation>
    </message>
</context>
<context>
    <name>wend::LayerPanel</name>
    <message>
        <source>The material is the same everywhere: brush over the shape to change a part.</source>
        <translation>Es igual en todas partes: pinte sobre la forma para cambiar una parte.</translation>
    </message>
    <message>
        <source>Each along a direction of its own.</source>
        <translation>Cada una en su propia dirección.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Lets the chosen layer win over the one above it.</source>
        <translation>Hace que la capa elegida prevalezca sobre la de encima.</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Lets the layer below win over the chosen one.</source>
        <translation>Hace que la capa de debajo prevalezca sobre la elegida.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Removes the chosen layer.</source>
        <translation>Elimina la capa elegida.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>How many times stiffer the layer is along its direction; ×1 is the same as everywhere.</source>
        <translation>Cuántas veces es más rígida la capa en su dirección; ×1 es como en todas partes.</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Dirección rígida</translation>
    </message>
    <message>
        <source>At rest; it turns with the shape. A change is for all regions of the layer.</source>
        <translation>En reposo; gira con la forma. Cambiarla vale para todas las regiones de la capa.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Borde suave</translation>
    </message>
    <message>
        <source>How wide the edge fades, in the shape&apos;s own units.</source>
        <translation>Anchura en la que se difumina el borde, en las unidades de la forma.</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>&amp;Borde suave</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Renombrar capa</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Mover capa</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Eliminar capa</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Cambiar borde suave</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>Cambiar capa</translation>
    </message>
    <message>
        <source>Unnamed</source>
        <translation>Sin nombre</translation>
    </message>
    <message>
        <source>Where the material differs. The topmost layer wins; drag a layer to move it. A click shows its values, a double-click changes its name, its eye or the space bar switches it off.</source>
        <translation>Dónde el material es otro. Prevalece la capa de más arriba: arrastre una capa a su lugar. Un clic muestra sus valores, un doble clic cambia su nombre, su ojo o la barra espaciadora la desactiva.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Imports the material from pictures made in a paint program, and exports it as such.</source>
        <translation>Importa el material desde imágenes de un programa de pintura, y lo exporta igual.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Volver a leer</translation>
    </message>
    <message>
        <source>Takes the pictures as they are now, after they have been saved in a paint program.</source>
        <translation>Toma las imágenes como están ahora, tras guardarlas en un programa de pintura.</translation>
    </message>
    <message>
        <source>Read pictures again</source>
        <translation>Volver a leer imágenes</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ocultar capa</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Mostrar capa</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Conservar: %1</translation>
    </message>
    <message>
        <source>Stiffness: %1</source>
        <translation>Rigidez: %1</translation>
    </message>
    <message>
        <source>Direction: %1</source>
        <translation>Dirección: %1</translation>
    </message>
    <message>
        <source>As the project&apos;s file says, cell by cell.</source>
        <translation>Según el archivo del proyecto, celda por celda.</translation>
    </message>
    <message>
        <source>Cell by cell: %1</source>
        <translation>Celda por celda: %1</translation>
    </message>
    <message>
        <source>Values of cells</source>
        <translation>Valores de celdas</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>&amp;Combinar hacia abajo</translation>
    </message>
    <message>
        <source>Makes one layer of the chosen one and the one below it</source>
        <translation>Une en una sola la capa elegida y la de debajo</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>Combinar capas</translation>
    </message>
    <message>
        <source>Stiffness ×1 has no direction: first choose how many times stiffer it is.</source>
        <translation>La rigidez ×1 no tiene dirección: elija primero cuántas veces más rígido es.</translation>
    </message>
    <message>
        <source>What a file gives cell by cell stays lowest.</source>
        <translation>Lo que un archivo dice de cada celda se queda abajo del todo.</translation>
    </message>
    <message>
        <source>This is already the lowest layer.</source>
        <translation>Ya es la capa más baja.</translation>
    </message>
    <message>
        <source>This is already the topmost layer.</source>
        <translation>Ya es la capa más alta.</translation>
    </message>
    <message>
        <source>One of the two is switched off, is a picture, or erases.</source>
        <translation>Una de las dos está desactivada, es una imagen o borra.</translation>
    </message>
    <message>
        <source>There is no layer below it.</source>
        <translation>No hay ninguna capa debajo.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Re&amp;nombrar</translation>
    </message>
    <message>
        <source>What a file says of each cell has no name.</source>
        <translation>Lo que un archivo dice de cada celda no tiene nombre.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Whether the layer changes Keep, and to what.</source>
        <translation>Si la capa cambia lo que se conserva, y a qué.</translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: de %2 a %3</translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>Principal</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation>%1[*] – Wend</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Let go to open “%1”</source>
        <translation>Suelte para abrir «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Let go to open %n pictures as parts</source>
        <translation>
            <numerusform>Suelte para abrir %n imagen como parte</numerusform>
            <numerusform>Suelte para abrir %n imágenes como partes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>The first page</source>
        <translation>La primera página</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>The previous page</source>
        <translation>La página anterior</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Eso no está en ninguna página.</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>Enter goes to the next place with these words, on this page or another.</source>
        <translation>Intro va al siguiente lugar donde están estas palabras, en esta página o en otra.</translation>
    </message>
</context>
<context>
    <name>wend::MaterialActions</name>
    <message>
        <source>A grey picture over the whole, as a layer: black keeps area, white keeps angles</source>
        <translation>Una imagen gris sobre el conjunto, como capa: el negro conserva el área, el blanco los ángulos</translation>
    </message>
    <message>
        <source>Import &amp;Stiffness…</source>
        <translation>Importar &amp;rigidez…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer: black is the same as everywhere, white is 1000 times stiffer</source>
        <translation>Una imagen gris sobre el conjunto, como capa: negro es como en todas partes, blanco 1000 veces más rígido</translation>
    </message>
    <message>
        <source>Import &amp;Directions…</source>
        <translation>Importar &amp;direcciones…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer, of the direction of stiffness: black is level, middle grey upright</source>
        <translation>Una imagen gris sobre el conjunto, como capa: negro horizontal, gris medio vertical; lo rígido lo es en esa dirección</translation>
    </message>
    <message>
        <source>Import Values of &amp;Cells…</source>
        <translation>Importar valores de c&amp;eldas…</translation>
    </message>
    <message>
        <source>φ and B of every cell from a mesh file that contains them, such as an exported one</source>
        <translation>φ y B de cada celda desde un archivo de malla que los contenga, por ejemplo uno exportado</translation>
    </message>
    <message>
        <source>As a grey picture, to be edited in a paint program</source>
        <translation>Como imagen gris, para continuar en un programa de pintura</translation>
    </message>
    <message>
        <source>Export S&amp;tiffness…</source>
        <translation>Exportar ri&amp;gidez…</translation>
    </message>
    <message>
        <source>Export Di&amp;rections…</source>
        <translation>Exportar direcci&amp;ones…</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>Mat&amp;erial</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Abra primero una imagen.</translation>
    </message>
    <message>
        <source>For a solid, these are values of cells; they are exported with its mesh.</source>
        <translation>En un sólido son valores de celdas; se exportan con su malla.</translation>
    </message>
    <message>
        <source>Only the cells of a mesh file stay the same.</source>
        <translation>Solo las celdas de un archivo de malla siguen siendo las mismas.</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Values of cells (*.vtu *.vtk *.json)</source>
        <translation>Valores de celdas (*.vtu *.vtk *.json)</translation>
    </message>
    <message>
        <source>The layers were switched off: what was imported lies below them.</source>
        <translation>Las capas están desactivadas: lo importado queda debajo de ellas.</translation>
    </message>
    <message>
        <source>Import &amp;Keep…</source>
        <translation>Importar &amp;Conservar…</translation>
    </message>
    <message>
        <source>Export K&amp;eep…</source>
        <translation>Exportar Conser&amp;var…</translation>
    </message>
</context>
<context>
    <name>wend::MaterialPanel</name>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Between %1 and %2.</source>
        <translation>Entre %1 y %2.</translation>
    </message>
    <message>
        <source>Grown ×%1 – try %2</source>
        <translation>Creció ×%1: pruebe %2</translation>
    </message>
    <message>
        <source>The shape has become much larger than at rest. A click keeps more of its size.</source>
        <translation>La forma es ahora mucho mayor que en reposo. Un clic conserva mejor su tamaño.</translation>
    </message>
    <message>
        <source>Whole shape</source>
        <translation>Toda la forma</translation>
    </message>
    <message>
        <source>Keep: whole shape</source>
        <translation>Conservar: toda la forma</translation>
    </message>
</context>
<context>
    <name>wend::MeasurePanel</name>
    <message>
        <source>Measures</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Size of the solid</source>
        <translation>Tamaño del sólido</translation>
    </message>
    <message>
        <source>Volume and area of the surface, now and at rest.</source>
        <translation>Volumen y área de la superficie, ahora y en reposo.</translation>
    </message>
    <message>
        <source>Size of what is selected</source>
        <translation>Tamaño de la selección</translation>
    </message>
    <message>
        <source>Volume of the tetrahedra and area of the outer triangles that the selected handles hold.</source>
        <translation>Volumen de los tetraedros y área de los triángulos exteriores que sujetan los agarres seleccionados.</translation>
    </message>
    <message>
        <source>Vertex under the pointer</source>
        <translation>Vértice bajo el puntero</translation>
    </message>
    <message>
        <source>The nearest vertex and where it is.</source>
        <translation>El vértice más cercano y su posición.</translation>
    </message>
    <message>
        <source>Tetrahedron under the pointer</source>
        <translation>Tetraedro bajo el puntero</translation>
    </message>
    <message>
        <source>All values of the tetrahedron.</source>
        <translation>Todos los valores del tetraedro.</translation>
    </message>
    <message>
        <source>%1, at rest %2</source>
        <translation>%1, en reposo %2</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>The whole</source>
        <translation>Sólido entero</translation>
    </message>
    <message numerus="yes">
        <source>Selected vertices: %n</source>
        <translation>
            <numerusform>Selección: %n vértice</numerusform>
            <numerusform>Selección: %n vértices</numerusform>
        </translation>
    </message>
    <message>
        <source>Point at the solid to see the values there.</source>
        <translation>Señale el sólido para ver ahí los valores.</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Vértice %1</translation>
    </message>
    <message>
        <source>place</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>pointed at</source>
        <translation>señalado</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>dihedral angles</source>
        <translation>ángulos diedros</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>circumradius to shortest edge</source>
        <translation>circunradio / arista más corta</translation>
    </message>
    <message>
        <source>Tetrahedron %1</source>
        <translation>Tetraedro %1</translation>
    </message>
</context>
<context>
    <name>wend::MemorySlider</name>
    <message>
        <source>not at all</source>
        <translation>nula</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>total</translation>
    </message>
</context>
<context>
    <name>wend::MeshPanel</name>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Maximum volume</source>
        <translation>Volumen máximo</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>What sets how fine the mesh is: how many vertices it has in total, or how large a tetrahedron may be.</source>
        <translation>Qué determina la finura de la malla: cuántos vértices tiene en total o lo grande que puede ser un tetraedro.</translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Pintar…</translation>
    </message>
    <message>
        <source>Cell sizes</source>
        <translation>Tamaños de celda</translation>
    </message>
    <message>
        <source>Paints where the mesh should be finer or coarser, or sets it by regions in numbers.</source>
        <translation>Pinta dónde la malla debe ser más fina o más gruesa, o lo indica con números por regiones.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>A&amp;im at</source>
        <translation>Ob&amp;jetivo</translation>
    </message>
    <message>
        <source>Detail: coarse – fine</source>
        <translation>Detalle: grueso – fino</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Más fino y más grueso</translation>
    </message>
    <message>
        <source>Aim at a volume</source>
        <translation>Objetivo: volumen</translation>
    </message>
    <message>
        <source>Aim at vertices</source>
        <translation>Objetivo: vértices</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>La malla procede de un archivo y se usa tal cual.</translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation>Esta imagen no tiene transparencia.</translation>
    </message>
    <message>
        <source>No outline has been drawn.</source>
        <translation>No se ha trazado ningún contorno.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 vértices, %2 tetraedros</translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation>%1 vértices, %2 triángulos</translation>
    </message>
    <message>
        <source>Outline and detail of</source>
        <translation>Contorno y detalle de</translation>
    </message>
    <message>
        <source>Which part of the picture has the outline and detail below; all have the same unless one has its own. Choosing a part in the list of parts chooses it here.</source>
        <translation>Qué parte de la imagen tiene el contorno y el detalle de abajo; todas tienen los mismos salvo que una tenga los suyos. Elegir una parte en la lista de partes la elige aquí.</translation>
    </message>
    <message>
        <source>As All Parts</source>
        <translation>Como todas las partes</translation>
    </message>
    <message>
        <source>Gives this part the outline and detail of all parts again.</source>
        <translation>Da de nuevo a esta parte el contorno y el detalle de todas.</translation>
    </message>
    <message>
        <source>&amp;Of</source>
        <translation>D&amp;e</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Todas las partes</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Elegir piel</translation>
    </message>
    <message>
        <source>Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view shows it, and surface formats contain it.</source>
        <translation>Toma de un archivo una superficie detallada, quizá con texturas: sigue al sólido, es lo que muestra la vista y lo que reciben los formatos de superficie.</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Eliminar piel</translation>
    </message>
    <message>
        <source>Shows and exports the solid with its own surface again.</source>
        <translation>El sólido vuelve a mostrarse y exportarse con su propia superficie.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
</context>
<context>
    <name>wend::ModeRow</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the picture is shown; a click shows its pixels as they are.</source>
        <translation>El tamaño al que se ve la imagen; un clic muestra sus píxeles tal como son.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Export what is shown as a picture, film, sequence, ST map, mesh or view</source>
        <translation>Exportar lo que se ve: como imagen, película, secuencia, mapa ST, malla o vista</translation>
    </message>
</context>
<context>
    <name>wend::MotionChooser</name>
    <message>
        <source>Apply Motion of Another Project</source>
        <translation>Aplicar el movimiento de otro proyecto</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Proyectos (*.wend)</translation>
    </message>
    <message>
        <source>This motion cannot be applied. %1</source>
        <translation>Este movimiento no se puede aplicar. %1</translation>
    </message>
    <message>
        <source>Apply motion of %1</source>
        <translation>Aplicar el movimiento de %1</translation>
    </message>
</context>
<context>
    <name>wend::Offers</name>
    <message>
        <source>This picture fills its frame. If its border is held, it bends inside and no gap opens at the edges.</source>
        <translation>Esta imagen llena su marco. Con el borde sujeto se deforma por dentro y no se abren huecos en los lados.</translation>
    </message>
    <message>
        <source>Hold the Border</source>
        <translation>Sujetar borde</translation>
    </message>
    <message>
        <source>Soft edges or shadows of this picture reach beyond the cut-out, and are cut off.</source>
        <translation>Los bordes suaves o las sombras de esta imagen salen del recorte y quedan cortados.</translation>
    </message>
    <message>
        <source>Include Them</source>
        <translation>Incluirlos</translation>
    </message>
    <message>
        <source>This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they enclose, too.</source>
        <translation>Esta imagen se compone sobre todo de líneas finas, y solo se doblarían las líneas. Con los huecos rellenos se dobla también lo que encierran.</translation>
    </message>
    <message>
        <source>Fill the Holes</source>
        <translation>Rellenar los huecos</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n imagen se abrió como parte: se dobla por sí sola.</numerusform>
            <numerusform>%n imágenes se abrieron como partes: cada una se dobla por sí sola. Únalas donde se encuentran, en Partes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layers were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n capa se abrió como parte: se dobla por sí sola.</numerusform>
            <numerusform>%n capas se abrieron como partes: cada una se dobla por sí sola. Únalas donde se encuentran, en Partes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open Flattened</source>
        <translation>Abrir acoplada</translation>
    </message>
    <message>
        <source>Open flattened</source>
        <translation>Abrir acoplada</translation>
    </message>
    <message>
        <source>Another Size…</source>
        <translation>Otro tamaño…</translation>
    </message>
    <message>
        <source>This drawing became a picture of %1 × %2 pixels.</source>
        <translation>Este dibujo se ha convertido en una imagen de %1 × %2 píxeles.</translation>
    </message>
</context>
<context>
    <name>wend::OpeningNote</name>
    <message>
        <source>Opening %1 …</source>
        <translation>Abriendo %1…</translation>
    </message>
</context>
<context>
    <name>wend::OptionRow</name>
    <message>
        <source>Options</source>
        <translation>Opciones</translation>
    </message>
</context>
<context>
    <name>wend::PaintPanel</name>
    <message>
        <source>How many times stiffer the painted part is along its direction; ×1 is the same as everywhere.</source>
        <translation>Cuántas veces es más rígida la parte pintada en su dirección; ×1 es como en todas partes.</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Dirección rígida</translation>
    </message>
    <message>
        <source>The direction at rest, which turns with the shape: the stroke&apos;s own, the one that is there, an axis, numbers, or the path of the selected pin where it is nearest.</source>
        <translation>La dirección en reposo, que gira con la forma: la del trazo, la que ya hay, un eje, números o la trayectoria del alfiler seleccionado donde queda más cerca.</translation>
    </message>
    <message>
        <source>Direction in numbers</source>
        <translation>Dirección en números</translation>
    </message>
    <message>
        <source>At rest; its length does not matter.</source>
        <translation>En reposo; su longitud no importa.</translation>
    </message>
    <message>
        <source>St&amp;iffness</source>
        <translation>Ri&amp;gidez</translation>
    </message>
    <message>
        <source>Di&amp;rection</source>
        <translation>Di&amp;rección</translation>
    </message>
    <message>
        <source>along the stroke</source>
        <translation>según el trazo</translation>
    </message>
    <message>
        <source>as it is there</source>
        <translation>la que ya hay</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>según X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>según Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>según Z</translation>
    </message>
    <message>
        <source>as numbers</source>
        <translation>en números</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>según la vista</translation>
    </message>
    <message>
        <source>along the pin&apos;s path</source>
        <translation>según el alfiler</translation>
    </message>
    <message>
        <source>What the brush paints</source>
        <translation>Lo que pinta el pincel</translation>
    </message>
    <message>
        <source>The brush paints</source>
        <translation>El pincel pinta</translation>
    </message>
</context>
<context>
    <name>wend::PartList</name>
    <message>
        <source>Joint x</source>
        <translation>Articulación x</translation>
    </message>
    <message>
        <source>Joint y</source>
        <translation>Articulación y</translation>
    </message>
    <message>
        <source>Move joint</source>
        <translation>Mover la articulación</translation>
    </message>
    <message>
        <source>Where the part turns at rest, in pixels from the upper left corner: a point in both parts, marked by a ring on the picture.</source>
        <translation>Dónde gira la parte en reposo, en píxeles desde la esquina superior izquierda: un punto de ambas partes, marcado con un anillo en la imagen.</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculta</translation>
    </message>
    <message>
        <source>rides on %1</source>
        <translation>sigue a %1</translation>
    </message>
    <message>
        <source>joined to %1</source>
        <translation>unida a %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Opac&amp;ity</source>
        <translation>Opac&amp;idad</translation>
    </message>
    <message>
        <source>&amp;Joined to</source>
        <translation>&amp;Unida a</translation>
    </message>
    <message>
        <source>&amp;Rides on</source>
        <translation>&amp;Sigue a</translation>
    </message>
    <message>
        <source>Parts of the picture</source>
        <translation>Partes de la imagen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Brings the part in front of the next one (Alt+Up).</source>
        <translation>Trae la parte delante de la siguiente (Alt+Arriba).</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Brings the part behind the next one (Alt+Down).</source>
        <translation>Lleva la parte detrás de la siguiente (Alt+Abajo).</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>How much is seen of the part.</source>
        <translation>Cuánto se ve de la parte.</translation>
    </message>
    <message>
        <source>Joined to</source>
        <translation>Unida a</translation>
    </message>
    <message>
        <source>Welds the part to another one in the middle of where they overlap at rest: it turns there, and pulls nothing else.</source>
        <translation>Une la parte a otra en el centro de su solapamiento en reposo: gira allí y no arrastra nada más.</translation>
    </message>
    <message>
        <source>Rides on</source>
        <translation>Sigue a</translation>
    </message>
    <message>
        <source>The part follows the motion of another one, as eyes do on a face.</source>
        <translation>La parte sigue el movimiento de otra, como los ojos en una cara.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Cambiar la opacidad</translation>
    </message>
    <message>
        <source>Choose a part that is not in front.</source>
        <translation>Elija una parte que no esté delante de todo.</translation>
    </message>
    <message>
        <source>Choose a part that is not at the back.</source>
        <translation>Elija una parte que no esté al fondo.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nada</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Ocultar la parte</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Mostrar la parte</translation>
    </message>
    <message>
        <source>Another part has this name.</source>
        <translation>Otra parte tiene este nombre.</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>Cambiar el nombre de la parte</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Cambiar el orden</translation>
    </message>
    <message>
        <source>These parts do not overlap at rest: there is no place for a joint.</source>
        <translation>Estas partes no se solapan en reposo: no hay lugar para una articulación.</translation>
    </message>
    <message>
        <source>Remove joint</source>
        <translation>Quitar la articulación</translation>
    </message>
    <message>
        <source>Join parts</source>
        <translation>Unir partes</translation>
    </message>
    <message>
        <source>Change what a part rides on</source>
        <translation>Cambiar a quién sigue una parte</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplicar</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Trama</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir luz</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>&amp;Blend mode</source>
        <translation>Modo de me&amp;zcla</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Modo de mezcla</translation>
    </message>
    <message>
        <source>How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen and Add lighten, as light does.</source>
        <translation>Cómo se combina la parte con lo que hay debajo: Multiplicar oscurece, como una sombra; Trama y Añadir luz aclaran, como la luz.</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Cambiar modo de mezcla</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>Borde sua&amp;ve</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Borde suave</translation>
    </message>
    <message>
        <source>How wide the edge is along which the part was cut out. The colours of what is behind it are removed from it.</source>
        <translation>Qué ancho tiene el borde por el que se recortó la parte. Se le quitan los colores de lo que hay detrás.</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Cambiar el borde suave</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies in front; click its eye to hide it; the lock at its end protects it from changes; a double-click changes its name.</source>
        <translation>La parte delantera es la primera. Arrastre una parte, o pulse Alt con las flechas, para cambiar el orden; pulse su ojo para ocultarla; el candado del final la protege de cambios; un doble clic cambia su nombre.</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>The part is seen, but clicks go through it, and it is neither painted nor are its pins moved.</source>
        <translation>La parte se ve, pero los clics la atraviesan; no se pinta ni se mueven sus alfileres.</translation>
    </message>
    <message>
        <source>Choose a part.</source>
        <translation>Elija una parte.</translation>
    </message>
    <message>
        <source>Lock part</source>
        <translation>Bloquear la parte</translation>
    </message>
    <message>
        <source>Unlock part</source>
        <translation>Desbloquear la parte</translation>
    </message>
</context>
<context>
    <name>wend::PartOrderRow</name>
    <message>
        <source>In Front from Here</source>
        <translation>Delante desde aquí</translation>
    </message>
    <message>
        <source>From the shown time on the part is in front of all others; before, it stays where it is.</source>
        <translation>A partir del tiempo mostrado la parte está delante de todas; antes, sigue donde está.</translation>
    </message>
    <message>
        <source>Behind from Here</source>
        <translation>Detrás desde aquí</translation>
    </message>
    <message>
        <source>From the shown time on the part is behind all others; before, it stays where it is.</source>
        <translation>A partir del tiempo mostrado la parte está detrás de todas; antes, sigue donde está.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nunca</translation>
    </message>
    <message>
        <source>Removes all changes of the order of this part.</source>
        <translation>Quita todos los cambios de orden de esta parte.</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>Mantener el orden</translation>
    </message>
    <message>
        <source>In front from here on</source>
        <translation>Delante de aquí en adelante</translation>
    </message>
    <message>
        <source>Behind from here on</source>
        <translation>Detrás de aquí en adelante</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Changes at %1</source>
        <translation>Cambia en %1</translation>
    </message>
</context>
<context>
    <name>wend::PictureActions</name>
    <message>
        <source>&amp;Add</source>
        <translation>Añad&amp;ir</translation>
    </message>
    <message>
        <source>What you draw will bend, too; Ctrl takes it away instead</source>
        <translation>Lo que se trace también se deformará; con Ctrl se quita</translation>
    </message>
    <message>
        <source>&amp;Take Away</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>What you draw will not bend; Ctrl adds it instead</source>
        <translation>Lo que se trace no se deformará; con Ctrl se añade</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen; also [ and ]</source>
        <translation>La anchura del pincel en pantalla; también [ y ]</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much colours may differ; this also changes the last click. Also [ and ]</source>
        <translation>Cuánto pueden diferir los colores, también los del último clic; también [ y ]</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>Crear una &amp;parte</translation>
    </message>
    <message>
        <source>What you draw becomes a part that bends by itself; what is behind it is filled</source>
        <translation>Lo que dibujes será una parte que se dobla por sí sola; lo de detrás se rellena</translation>
    </message>
</context>
<context>
    <name>wend::PictureDialog</name>
    <message>
        <source>%1 has no transparency: the background is that of the view.</source>
        <translation>%1 no tiene transparencia: el fondo es el de la vista.</translation>
    </message>
    <message>
        <source>&amp;Proportions of the view</source>
        <translation>&amp;Proporciones de la vista</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Fondo &amp;transparente</translation>
    </message>
    <message>
        <source>P&amp;ins and axes</source>
        <translation>Alf&amp;ileres y ejes</translation>
    </message>
    <message>
        <source>Export View</source>
        <translation>Exportar vista</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>El tipo de archivo que se exporta.</translation>
    </message>
    <message>
        <source>Proportions of the view</source>
        <translation>Proporciones de la vista</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the view shows.</source>
        <translation>La anchura y la altura van unidas, para que la imagen muestre lo mismo que la vista.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Anchura de la imagen en píxeles.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height of the picture in pixels; it decides how large the solid is.</source>
        <translation>Altura de la imagen en píxeles; determina el tamaño del sólido.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Fondo transparente</translation>
    </message>
    <message>
        <source>Only the solid, without a background.</source>
        <translation>Solo el sólido, sin fondo.</translation>
    </message>
    <message>
        <source>Pins and axes</source>
        <translation>Alfileres y ejes</translation>
    </message>
    <message>
        <source>Pins, their paths and the axes, as large as in the window.</source>
        <translation>Alfileres, trayectorias y ejes, al mismo tamaño que en la ventana.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormato</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Anchura</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>Alt&amp;ura</translation>
    </message>
    <message>
        <source>Width and height must be between %1 and %2 pixels.</source>
        <translation>La anchura y la altura deben estar entre %1 y %2 píxeles.</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message>
        <source>&amp;Legend of the overlay</source>
        <translation>&amp;Leyenda de la superposición</translation>
    </message>
    <message>
        <source>Legend of the overlay</source>
        <translation>Leyenda de la superposición</translation>
    </message>
    <message>
        <source>The colours of the overlay and their values.</source>
        <translation>Los colores de la superposición y sus valores.</translation>
    </message>
    <message>
        <source>Show the colour overlay first: it has the legend.</source>
        <translation>Muestre primero la superposición de color: la leyenda es suya.</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Exportar película</translation>
    </message>
</context>
<context>
    <name>wend::PictureKeeper</name>
    <message>
        <source>The picture “%1” was changed by another program.</source>
        <translation>Otro programa ha modificado la imagen «%1».</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Reload picture</source>
        <translation>Recargar imagen</translation>
    </message>
    <message>
        <source>Replace Picture</source>
        <translation>Reemplazar imagen</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Replace picture</source>
        <translation>Reemplazar imagen</translation>
    </message>
    <message>
        <source>The picture cannot be read. %1</source>
        <translation>No se puede leer la imagen. %1</translation>
    </message>
    <message>
        <source>It has %1 × %2 pixels, and the picture before had %3 × %4.</source>
        <translation>Tiene %1 × %2 píxeles y la imagen anterior tenía %3 × %4.</translation>
    </message>
    <message>
        <source>This picture has other proportions. %1</source>
        <translation>Esta imagen tiene otras proporciones. %1</translation>
    </message>
    <message>
        <source>The picture has other proportions now. %1</source>
        <translation>La imagen tiene ahora otras proporciones. %1</translation>
    </message>
    <message>
        <source>Pins and paths are scaled with it. %1</source>
        <translation>Los alfileres y trayectorias se han escalado con ella. %1</translation>
    </message>
    <message>
        <source>Change drawing size</source>
        <translation>Cambiar el tamaño del dibujo</translation>
    </message>
</context>
<context>
    <name>wend::PinActions</name>
    <message>
        <source>&amp;Pins</source>
        <translation>&amp;Alfileres</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Bloquear</translation>
    </message>
    <message>
        <source>The selected pins are neither moved nor removed until unlocked</source>
        <translation>Impedir que los alfileres seleccionados se muevan o eliminen hasta que se desbloqueen</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Oc&amp;ultar</translation>
    </message>
    <message>
        <source>The selected pins still hold, but are neither drawn nor picked</source>
        <translation>No mostrar ni dejar elegir los alfileres seleccionados, que siguen sujetando</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>Mostrar ocu&amp;ltos</translation>
    </message>
    <message>
        <source>Show all hidden pins again</source>
        <translation>Volver a mostrar todos los alfileres ocultos</translation>
    </message>
    <message>
        <source>Alt+Shift+H</source>
        <translation>Alt+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Group…</source>
        <translation>A&amp;grupar…</translation>
    </message>
    <message>
        <source>Put the selected pins under a heading of the list</source>
        <translation>Reunir los alfileres seleccionados bajo un título de la lista</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>&amp;Desagrupar</translation>
    </message>
    <message>
        <source>Take the selected pins out of their groups</source>
        <translation>Sacar los alfileres seleccionados de sus grupos</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Lin&amp;k</source>
        <translation>&amp;Vincular</translation>
    </message>
    <message>
        <source>The selected pins move together, whichever of them is dragged</source>
        <translation>Mover juntos los alfileres seleccionados, se arrastre el que se arrastre</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Re&amp;flejar</translation>
    </message>
    <message>
        <source>Set pins at the mirror images of the selected ones, across the middle of the shape, with mirrored motions</source>
        <translation>Poner alfileres simétricos a los seleccionados respecto al centro de la forma, con movimientos reflejados</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Mirror M&amp;otion</source>
        <translation>Refle&amp;jar movimiento</translation>
    </message>
    <message>
        <source>The selected pins move to the other side instead</source>
        <translation>Hacer que los alfileres seleccionados se muevan hacia el otro lado</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>Marrón</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>Turquesa</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>Ciruela</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Color</translation>
    </message>
    <message>
        <source>By &amp;Place in the List</source>
        <translation>Según el &amp;puesto en la lista</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>&amp;Otro…</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Seleccione primero un alfiler.</translation>
    </message>
    <message>
        <source>The selected pin is in no group.</source>
        <translation>El alfiler seleccionado no está en ningún grupo.</translation>
    </message>
    <message>
        <source>Select several pins first.</source>
        <translation>Seleccione primero varios alfileres.</translation>
    </message>
    <message>
        <source>Select a pin that moves.</source>
        <translation>Seleccione un alfiler que se mueva.</translation>
    </message>
    <message>
        <source>No pin is hidden.</source>
        <translation>No hay ningún alfiler oculto.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Agrupar</translation>
    </message>
    <message>
        <source>Name of the group:</source>
        <translation>Nombre del grupo:</translation>
    </message>
    <message>
        <source>Colour of the Pin</source>
        <translation>Color del alfiler</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Mo&amp;ve</source>
        <translation>Mo&amp;ver</translation>
    </message>
    <message>
        <source>Drag pins to move them; in a solid, also by the arrows</source>
        <translation>Arrastre los alfileres para moverlos; en un sólido, también sus flechas</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Rotar</translation>
    </message>
    <message>
        <source>Drag to rotate the selected pins; in a solid, by the rings</source>
        <translation>Arrastre para rotar los alfileres seleccionados; en un sólido, por sus anillos</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>Es&amp;calar</translation>
    </message>
    <message>
        <source>Drag to scale the selected pins; in a solid, by the ring</source>
        <translation>Arrastre para escalar los alfileres seleccionados; en un sólido, por su anillo</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Abra primero una imagen.</translation>
    </message>
    <message>
        <source>Select &amp;Pins</source>
        <translation>Seleccionar alfi&amp;leres</translation>
    </message>
    <message>
        <source>What the pin tool and the select tool draw around pins to select them</source>
        <translation>Lo que se traza junto a los alfileres, con la herramienta Alfiler o Seleccionar, para seleccionarlos</translation>
    </message>
    <message>
        <source>By &amp;Rectangle</source>
        <translation>Con &amp;rectángulo</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>By &amp;Lasso</source>
        <translation>Con &amp;lazo</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>By &amp;Brush</source>
        <translation>Con &amp;pincel</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>A&amp;dherir</translation>
    </message>
    <message>
        <source>New pins sit on corners of the mesh instead of where you click</source>
        <translation>Poner los alfileres nuevos en vértices de la malla en vez de donde se hace clic</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ].</source>
        <translation>El diámetro del pincel en pantalla; también con las teclas [ y ].</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pin for the Whole &amp;Animation</source>
        <translation>Fijar toda la &amp;animación</translation>
    </message>
    <message>
        <source>The selected pins hold from the start of the animation to its end, not only from the time at which they were set</source>
        <translation>Los alfileres seleccionados sujetan desde el principio de la animación hasta el final, no solo desde el momento en que se pusieron</translation>
    </message>
    <message>
        <source>The selected pin already holds for the whole animation.</source>
        <translation>El alfiler seleccionado ya sujeta toda la animación.</translation>
    </message>
</context>
<context>
    <name>wend::PinList</name>
    <message>
        <source>Pins</source>
        <translation>Alfileres</translation>
    </message>
    <message>
        <source>Does not hold at the time shown.</source>
        <translation>No sujeta en el momento que se muestra.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow keys move them. The eye hides, the lock protects from changes; a right-click groups, links and mirrors.</source>
        <translation>Elija aquí los alfileres; F2 renombra, Supr elimina, Intro pasa a la imagen, donde las flechas los mueven. El ojo oculta, el candado protege de cambios; el clic derecho agrupa, vincula y refleja.</translation>
    </message>
    <message>
        <source>Moves together with others</source>
        <translation>Se mueve junto con otros</translation>
    </message>
    <message>
        <source>Hidden: a click shows it</source>
        <translation>Oculto: un clic lo muestra</translation>
    </message>
    <message>
        <source>A click hides it</source>
        <translation>Un clic lo oculta</translation>
    </message>
    <message>
        <source>Locked: a click unlocks it</source>
        <translation>Bloqueado: un clic lo desbloquea</translation>
    </message>
    <message>
        <source>A click locks it</source>
        <translation>Un clic lo bloquea</translation>
    </message>
    <message>
        <source>No pins yet</source>
        <translation>Aún no hay alfileres</translation>
    </message>
</context>
<context>
    <name>wend::ProblemRemedies</name>
    <message>
        <source>Use Multigrid</source>
        <translation>Usar multimalla</translation>
    </message>
    <message>
        <source>Half as Many Vertices</source>
        <translation>La mitad de vértices</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
</context>
<context>
    <name>wend::Properties</name>
    <message>
        <source>Advanced</source>
        <translation>Avanzado</translation>
    </message>
    <message>
        <source>The same in numbers, for those who want them.</source>
        <translation>Lo mismo en números, para quien los quiera.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detalle</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Alfileres</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flujo</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Qué ha cambiado</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Size, area, volume and edges, the quality of the cells, and gaps that a cage closes.</source>
        <translation>Tamaño, área, volumen y aristas, calidad de las celdas y huecos que cierra una jaula.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
</context>
<context>
    <name>wend::PropertiesRail</name>
    <message>
        <source>Opens this part of the properties over the view; Esc closes it.</source>
        <translation>Abre esta parte de las propiedades sobre la vista; Esc la cierra.</translation>
    </message>
</context>
<context>
    <name>wend::ReachRow</name>
    <message>
        <source>Pull reaches</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads. Near: close to the pin, sharp. Far: soft and wide.</source>
        <translation>Hasta dónde se reparte el tirón de un alfiler. Cerca: junto al alfiler, nítido. Lejos: suave y amplio.</translation>
    </message>
    <message>
        <source>Pull &amp;reaches</source>
        <translation>Alca&amp;nce</translation>
    </message>
    <message>
        <source>near</source>
        <translation>cerca</translation>
    </message>
    <message>
        <source>far</source>
        <translation>lejos</translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Este proyecto se suaviza como en el artículo, con λ; su archivo dice cuánto.</translation>
    </message>
</context>
<context>
    <name>wend::RegionList</name>
    <message>
        <source>The mesh is equally fine everywhere: brush over what should be finer or coarser.</source>
        <translation>La malla es igual de fina en todas partes: pase el pincel donde deba ser más fina o más gruesa.</translation>
    </message>
    <message>
        <source>Nothing has an order of its own: brush over what should lie in front or behind.</source>
        <translation>Nada tiene un orden propio: pase el pincel sobre lo que deba quedar delante o detrás.</translation>
    </message>
    <message>
        <source>Where the mesh is finer or coarser</source>
        <translation>Dónde la malla es más fina o más gruesa</translation>
    </message>
    <message>
        <source>What lies in front</source>
        <translation>Lo que queda delante</translation>
    </message>
    <message>
        <source>The strokes and regions so far; where two overlap, the upper one counts. A click shows where it lies and its number, a double-click changes its name.</source>
        <translation>Los trazos y regiones que hay; de dos en un mismo lugar vale el de arriba. Un clic muestra dónde está y su número, un doble clic cambia su nombre.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>Longitud de aristas</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>How long edges are there, compared with elsewhere: less is finer, more is coarser.</source>
        <translation>Longitud de las aristas en ese lugar respecto a las demás: menos es más fino, más es más grueso.</translation>
    </message>
    <message>
        <source>Greater than 0 lies in front, less than 0 behind.</source>
        <translation>Mayor que 0 queda delante; menor, detrás.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Removes the chosen region.</source>
        <translation>Quita la región elegida.</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Más fino y más grueso</translation>
    </message>
    <message>
        <source>In front and behind</source>
        <translation>Delante y detrás</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>Arist&amp;as</translation>
    </message>
    <message>
        <source>O&amp;rder</source>
        <translation>Or&amp;den</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Cambiar aristas</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Cambiar orden</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>Eliminar región</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un lado</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Renombrar región</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Añadir región</translation>
    </message>
    <message>
        <source>A ball, a box or a half-space in the middle, or what the selected handle holds as a region; its numbers can then be changed.</source>
        <translation>Una esfera, una caja o un semiespacio en el centro, o la región que sujeta el agarre seleccionado; luego se pueden cambiar sus números.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Borde suave</translation>
    </message>
    <message>
        <source>Over what width the size blends into that around it, in the file&apos;s units.</source>
        <translation>Anchura en la que el tamaño pasa al de alrededor, en unidades del archivo.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Semiespacio</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Region of the selected handle</source>
        <translation>Región del agarre seleccionado</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>&amp;Borde suave</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Cambiar región</translation>
    </message>
    <message>
        <source>Add size region</source>
        <translation>Añadir región de tamaño</translation>
    </message>
    <message>
        <source>First select a pin that holds a ball, a box or one side.</source>
        <translation>Seleccione primero un alfiler que sujete una bola, un bloque o un lado.</translation>
    </message>
    <message>
        <source>Beneath them: the factors in %1.</source>
        <translation>Debajo: los factores de %1.</translation>
    </message>
    <message>
        <source>The surface&apos;s triangles are kept, and only the inside changes. “Refine surface” in the panel “Mesh” allows them to be split, too.</source>
        <translation>Los triángulos de la superficie se conservan y solo cambia el interior. «Refinar superficie», en el panel «Malla», permite dividirlos también.</translation>
    </message>
</context>
<context>
    <name>wend::RegionNumbers</name>
    <message>
        <source>Numbers of the region</source>
        <translation>Números de la región</translation>
    </message>
    <message>
        <source>As x, y and z, in the coordinates of the rest shape.</source>
        <translation>En x, y y z, en las coordenadas de la forma en reposo.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Semiespacio</translation>
    </message>
    <message>
        <source>Kind of region</source>
        <translation>Tipo de región</translation>
    </message>
    <message>
        <source>What the region is; another kind keeps its place.</source>
        <translation>Qué es la región; otro tipo conserva su sitio.</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>Re&amp;gión</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>point of the plane</source>
        <translation>punto del plano</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>direction into it</source>
        <translation>dirección hacia dentro</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>The radius of the ball.</source>
        <translation>El radio de la esfera.</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Ra&amp;dio</translation>
    </message>
</context>
<context>
    <name>wend::RegionPanel</name>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>There is no vertex in this region: nothing was changed.</source>
        <translation>No hay ningún vértice en esta región: no se ha cambiado nada.</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Cambiar región</translation>
    </message>
    <message numerus="yes">
        <source>Vertices: %n</source>
        <translation>
            <numerusform>%n vértice</numerusform>
            <numerusform>%n vértices</numerusform>
        </translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Ra&amp;dio</translation>
    </message>
    <message>
        <source>Holds its a&amp;ngle</source>
        <translation>&amp;Mantiene su ángulo</translation>
    </message>
    <message>
        <source>How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. In the shape&apos;s own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does the same.</source>
        <translation>Hasta dónde sujeta el alfiler la forma a su alrededor: 0 sujeta un punto, más, un círculo o, en un sólido, una bola. En las unidades de la forma; en una imagen, sus píxeles. Arrastrar el alfiler con Ctrl y Mayús hace lo mismo.</translation>
    </message>
    <message>
        <source>The pin keeps the angle that the picture has there now, as a small circle; without it, the picture turns freely around the pin.</source>
        <translation>El alfiler mantiene, como un círculo pequeño, el ángulo que la imagen tiene ahí ahora; sin esto, la imagen gira libremente alrededor del alfiler.</translation>
    </message>
</context>
<context>
    <name>wend::RidingOffer</name>
    <message>
        <source>A part has no pin and stays behind: let it ride on “%1”?</source>
        <translation>Una parte no tiene alfiler y se queda atrás: ¿que siga a «%1»?</translation>
    </message>
    <message>
        <source>A part has no pin and stays behind: let it ride on what is beside it?</source>
        <translation>Una parte no tiene alfiler y se queda atrás: ¿que siga a lo que tiene al lado?</translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on “%1”?</source>
        <translation>
            <numerusform>%n parte no tiene alfiler y se queda atrás: ¿que siga a «%1»?</numerusform>
            <numerusform>%n partes no tienen alfiler y se quedan atrás: ¿que sigan a «%1»?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on what is beside them?</source>
        <translation>
            <numerusform>%n parte no tiene alfiler y se queda atrás: ¿que siga a lo que tiene al lado?</numerusform>
            <numerusform>%n partes no tienen alfiler y se quedan atrás: ¿que sigan a lo que tienen al lado?</numerusform>
        </translation>
    </message>
    <message>
        <source>Let parts ride</source>
        <translation>Hacer que las partes sigan</translation>
    </message>
    <message>
        <source>Let It Ride</source>
        <translation>Que siga</translation>
    </message>
    <message>
        <source>Let Them Ride</source>
        <translation>Que sigan</translation>
    </message>
</context>
<context>
    <name>wend::ShapeCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation>La imagen con sus alfileres</translation>
    </message>
</context>
<context>
    <name>wend::ShapeNotices</name>
    <message>
        <source>“Refine surface” in the panel “Mesh” allows the surface&apos;s triangles to be split.</source>
        <translation>«Refinar superficie», en el panel «Malla», permite dividir los triángulos de la superficie.</translation>
    </message>
    <message>
        <source>Pin It</source>
        <translation>Fijar con alfiler</translation>
    </message>
    <message>
        <source>A part is joined to the rest at a single point, and may swing around it unless a pin holds it.</source>
        <translation>Una parte está unida al resto solo por un punto y puede girar en torno a él si ningún alfiler la sujeta.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts are joined to the rest at single points, and may swing around them unless pins hold them.</source>
        <translation>
            <numerusform>%n parte está unida al resto solo por un punto y puede girar en torno a él si ningún alfiler la sujeta.</numerusform>
            <numerusform>%n partes están unidas al resto solo por puntos y pueden girar en torno a ellos si ningún alfiler las sujeta.</numerusform>
        </translation>
    </message>
    <message>
        <source>See Why</source>
        <translation>Ver por qué</translation>
    </message>
    <message>
        <source>Fill All, with Labels</source>
        <translation>Llenar todo, con etiquetas</translation>
    </message>
    <message>
        <source>Leave Holes</source>
        <translation>Dejar huecos</translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>Widen %1</source>
        <translation>Ensanchar %1</translation>
    </message>
    <message>
        <source>%1 cannot go further: %2</source>
        <translation>%1 no puede ir más lejos: %2</translation>
    </message>
    <message>
        <source>Cancelled: everything is as it was before the last change.</source>
        <translation>Cancelado: todo está como antes del último cambio.</translation>
    </message>
    <message>
        <source>Meshing was cancelled. Any change, such as fewer vertices, starts it again.</source>
        <translation>Se ha cancelado el mallado. Cualquier cambio vuelve a mallar, por ejemplo reducir los vértices.</translation>
    </message>
    <message>
        <source>The motion was cancelled. Any change computes it again.</source>
        <translation>Se ha cancelado el movimiento. Cualquier cambio lo vuelve a calcular.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>No pin was set: this place lies outside the shape.</source>
        <translation>Aquí no hay alfiler: este lugar queda fuera de la forma.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>%1 does not hold the shape at the time shown.</source>
        <translation>%1 no sujeta la forma en el momento que se muestra.</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Escalar %1</translation>
    </message>
    <message>
        <source>This replaces what came after; Undo brings it back.</source>
        <translation>Esto reemplaza lo que venía después; Deshacer lo recupera.</translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation>
            <numerusform>%n alfiler</numerusform>
            <numerusform>%n alfileres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1 (reflejo)</translation>
    </message>
    <message>
        <source>No pin was set where the mirror image lies outside the shape.</source>
        <translation>Donde el reflejo cae fuera de la forma no se pone ningún alfiler.</translation>
    </message>
    <message>
        <source>There is already a pin where the mirror image would be.</source>
        <translation>Ya hay un alfiler donde quedaría el reflejo.</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Reflejar %1</translation>
    </message>
    <message>
        <source>Mirror the motion of %1</source>
        <translation>Reflejar el movimiento de %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Bloquear %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Desbloquear %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Ocultar %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostrar %1</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>Desagrupar %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Agrupar %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Renombrar grupo</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Cambiar el color de %1</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Vincular %1</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>Desvincular %1</translation>
    </message>
    <message>
        <source>%1 is locked. A right-click or the list of pins unlocks it.</source>
        <translation>%1 está bloqueado. El clic derecho o la lista de alfileres lo desbloquea.</translation>
    </message>
    <message>
        <source>%1 are locked. A right-click or the list of pins unlocks them.</source>
        <translation>%1 están bloqueados. El clic derecho o la lista de alfileres los desbloquea.</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Grabar %1</translation>
    </message>
    <message>
        <source>Recorded. K plays it; record other pins from the same time, and they move together.</source>
        <translation>Grabado. K lo reproduce; otros alfileres grabados desde el mismo momento se mueven a la vez.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Alfiler</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>Editar trayectoria</translation>
    </message>
    <message>
        <source>Draw the path of %1</source>
        <translation>Dibujar la trayectoria de %1</translation>
    </message>
    <message>
        <source>K plays it; draw the paths of other pins from the same time, and they move together.</source>
        <translation>K reproduce; dibuje las trayectorias de otros alfileres desde el mismo momento y se moverán juntos.</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Relajar</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>Rotar %1</translation>
    </message>
    <message>
        <source>This replaces what %1 did later; Undo brings it back.</source>
        <translation>Esto reemplaza lo que %1 hacía después; Deshacer lo recupera.</translation>
    </message>
    <message>
        <source>This circle is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Este círculo es menor que las celdas de la malla: hágalo mayor o la malla más fina.</translation>
    </message>
    <message>
        <source>This ball is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Esta bola es menor que las celdas de la malla: hágala mayor o la malla más fina.</translation>
    </message>
    <message>
        <source>Pin %1 for the whole animation</source>
        <translation>Fijar %1 toda la animación</translation>
    </message>
    <message>
        <source>The film is longer by a second: what you had timed keeps its times.</source>
        <translation>La película dura un segundo más: lo que tenía tiempos los conserva.</translation>
    </message>
    <message>
        <source>The film is longer by a second. At an earlier time a drag sets the pose there.</source>
        <translation>La película dura un segundo más. En un tiempo anterior, arrastrar fija allí la pose.</translation>
    </message>
    <message>
        <source>Posed at %1 s: what comes before and after stays.</source>
        <translation>Pose en %1 s: lo anterior y lo posterior se conserva.</translation>
    </message>
    <message>
        <source>No pose was set where a pin begins, rotates or does not hold: show another time.</source>
        <translation>No se fijó ninguna pose donde un pin empieza, gira o no sujeta: muestre otro momento.</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>Sujetar %1</translation>
    </message>
    <message>
        <source>The last move goes straight there now. Motion ▸ Keep the Path leads pins on instead.</source>
        <translation>El último movimiento va ahora recto hasta ahí. Movimiento ▸ Conservar el camino lleva los pines más allá en su lugar.</translation>
    </message>
    <message>
        <source>%1 is in a part that is locked. The list of parts unlocks it.</source>
        <translation>%1 está en una parte bloqueada. La lista de partes la desbloquea.</translation>
    </message>
    <message>
        <source>A part is still being made. Pins can be dragged as soon as it is there.</source>
        <translation>Una parte aún se está haciendo. Los alfileres se podrán arrastrar en cuanto esté.</translation>
    </message>
    <message>
        <source>The motion stops at %1 s: %2</source>
        <translation>El movimiento se detiene a los %1 s: %2</translation>
    </message>
</context>
<context>
    <name>wend::ShortcutDialog</name>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguna</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Estándar</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Search for an action or for keys</source>
        <translation>Buscar una acción o unas teclas</translation>
    </message>
    <message>
        <source>&amp;All Standard</source>
        <translation>&amp;Todo estándar</translation>
    </message>
    <message>
        <source>Give every action the keys that it has in a new Wend</source>
        <translation>Dar a cada acción las teclas que tiene en un Wend nuevo</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>Te&amp;clas</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Click here, then press the keys</source>
        <translation>Haga clic aquí y pulse las teclas</translation>
    </message>
    <message>
        <source>Leave the chosen action without keys</source>
        <translation>Dejar la acción elegida sin teclas</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it has in a new Wend</source>
        <translation>Dar a la acción elegida las teclas que tiene en un Wend nuevo</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Acciones</translation>
    </message>
    <message>
        <source>Choose an action, then press the keys that it shall have.</source>
        <translation>Elija una acción y pulse las teclas que debe tener.</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: the canvas uses it.</source>
        <translation>No se puede elegir %1: lo usa el lienzo.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>Se ha quitado a %1.</translation>
    </message>
</context>
<context>
    <name>wend::SideWindows</name>
    <message>
        <source>As it was opened</source>
        <translation>Tal como se abrió</translation>
    </message>
    <message>
        <source>What was done; a click goes back or forward to that step.</source>
        <translation>Lo que se ha hecho; un clic retrocede o avanza hasta ese paso.</translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation>Acerca de Wend</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Deforma imágenes y sólidos dejándolos fluir.&lt;/p&gt;&lt;p&gt;Basado en J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Software libre bajo la licencia GNU Affero General Public License, versión 3 o posterior.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
</context>
<context>
    <name>wend::SolidActions</name>
    <message>
        <source>Through the &amp;Solid</source>
        <translation>A &amp;través del sólido</translation>
    </message>
    <message>
        <source>Rectangle, lasso and brush also take or select what is hidden</source>
        <translation>Rectángulo, lazo y pincel también toman o seleccionan lo que está oculto</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Grab Beyond the &amp;Cut</source>
        <translation>Agarrar &amp;más allá del corte</translation>
    </message>
    <message>
        <source>Take hold of all that the cut takes away, as one handle</source>
        <translation>Sujetar como un solo agarre todo lo que el corte quita</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>P&amp;iel</translation>
    </message>
    <message>
        <source>Show the detailed or textured surface embedded in the solid; off: the border of the tetrahedra, which bend</source>
        <translation>Mostrar la superficie detallada o con texturas que sigue al sólido; si no, el borde de los tetraedros, que son los que se deforman</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Choose Sk&amp;in…</source>
        <translation>Ele&amp;gir piel…</translation>
    </message>
    <message>
        <source>Embed a detailed, perhaps textured surface from a file in the solid</source>
        <translation>Hacer que una superficie detallada de un archivo, quizá con texturas, siga al sólido</translation>
    </message>
    <message>
        <source>Re&amp;move Skin</source>
        <translation>&amp;Quitar piel</translation>
    </message>
    <message>
        <source>Show and export the solid with its own surface again</source>
        <translation>Volver a mostrar y exportar el sólido con su propia superficie</translation>
    </message>
    <message>
        <source>&amp;Flat Faces</source>
        <translation>Caras &amp;planas</translation>
    </message>
    <message>
        <source>Shade every triangle by itself instead of smoothly</source>
        <translation>Sombrear cada triángulo por separado, sin suavizar</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Parallel View</source>
        <translation>Vista paralel&amp;a</translation>
    </message>
    <message>
        <source>See without perspective</source>
        <translation>Ver sin perspectiva</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>&amp;Cut Open</source>
        <translation>&amp;Cortar</translation>
    </message>
    <message>
        <source>Look inside along a plane; an arrow and rings move and tilt it</source>
        <translation>Mirar dentro por un plano; una flecha y unos anillos lo mueven y lo inclinan</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Look along an axis of the world</source>
        <translation>Mirar a lo largo de un eje del mundo</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Fr&amp;ente</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>De&amp;trás</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Derecha</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Arriba</translation>
    </message>
    <message>
        <source>7</source>
        <translation>7</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>A&amp;bajo</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Oblicua</translation>
    </message>
    <message>
        <source>Look from the side and above</source>
        <translation>Mirar desde un lado y desde arriba</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>&amp;Wend</source>
        <translation>&amp;Wend</translation>
    </message>
    <message>
        <source>Right or middle button turns, with Shift moves; the wheel zooms</source>
        <translation>El botón derecho o central gira, con Mayús desplaza; la rueda acerca o aleja</translation>
    </message>
    <message>
        <source>Like &amp;VTK</source>
        <translation>Como &amp;VTK</translation>
    </message>
    <message>
        <source>Left button turns, middle moves, right zooms, as in ParaView</source>
        <translation>El botón izquierdo gira, el central desplaza, el derecho acerca o aleja, como en ParaView</translation>
    </message>
    <message>
        <source>Like &amp;Blender</source>
        <translation>Como &amp;Blender</translation>
    </message>
    <message>
        <source>Middle button turns, with Shift moves, with Ctrl zooms</source>
        <translation>El botón central gira, con Mayús desplaza, con Ctrl acerca o aleja</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>&amp;Sólido</translation>
    </message>
    <message>
        <source>L&amp;ook from</source>
        <translation>&amp;Ver desde</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navegación</translation>
    </message>
    <message>
        <source>The solid has neither a detailed surface nor materials.</source>
        <translation>El sólido no tiene superficie detallada ni materiales.</translation>
    </message>
    <message>
        <source>No detailed surface was chosen for the solid.</source>
        <translation>No se ha elegido ninguna superficie detallada para el sólido.</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>La malla procede de un archivo y se usa tal cual.</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Abra primero un sólido.</translation>
    </message>
    <message>
        <source>Which axis of the world points up in the view; kept with the project</source>
        <translation>Qué eje del mundo apunta hacia arriba en la vista; se guarda con el proyecto</translation>
    </message>
    <message>
        <source>&amp;X Points Up</source>
        <translation>&amp;X hacia arriba</translation>
    </message>
    <message>
        <source>&amp;Y Points Up</source>
        <translation>&amp;Y hacia arriba</translation>
    </message>
    <message>
        <source>&amp;Z Points Up</source>
        <translation>&amp;Z hacia arriba</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>Eje &amp;vertical</translation>
    </message>
</context>
<context>
    <name>wend::SolidCanvas</name>
    <message>
        <source>there is not enough memory for a picture of %1 x %2 pixels</source>
        <translation>la memoria no alcanza para una imagen de %1 x %2 píxeles</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>Exportando la imagen…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Celda %1</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Exportando la película…</translation>
    </message>
</context>
<context>
    <name>wend::SolidWorkshop</name>
    <message>
        <source>Solids need OpenGL 3.3, which this system does not have. The command line (wend run) still works with them.</source>
        <translation>Los sólidos necesitan OpenGL 3.3, que este sistema no tiene. La línea de comandos (wend run) funciona con ellos de todos modos.</translation>
    </message>
    <message>
        <source>These pictures of the surface cannot be read: %1</source>
        <translation>No se pueden leer estas imágenes de la superficie: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Exportado: %1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>No se ha exportado nada. %1</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zona</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>La forma aún se está calculando. Inténtelo de nuevo en un momento.</translation>
    </message>
</context>
<context>
    <name>wend::SoundTrack</name>
    <message>
        <source>The sound is not shown: that needs the program ffmpeg (Debian: sudo apt install ffmpeg).</source>
        <translation>El sonido no se muestra: para ello hace falta el programa ffmpeg (Debian: sudo apt install ffmpeg).</translation>
    </message>
    <message>
        <source>The sound %1 cannot be read: is the file there?</source>
        <translation>No se puede leer el sonido %1: ¿está el archivo?</translation>
    </message>
</context>
<context>
    <name>wend::SpringOffer</name>
    <message>
        <source>What comes back leaves the shape a little different, so that a loop jumps. If the shape springs back fully, it is as it was.</source>
        <translation>Lo que vuelve deja la forma algo distinta, y un bucle da un salto. Si la forma se recupera del todo, queda como estaba.</translation>
    </message>
    <message>
        <source>Spring Back Fully</source>
        <translation>Recuperar del todo</translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation>Clave alfileres en una imagen, tire de ellos y déjela fluir.</translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation>Suelte aquí una imagen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation>Elegir una imagen, una malla plana o un proyecto.</translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation>Pruebe un ejemplo</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Five-minute tutorial</source>
        <translation>Tutorial de cinco minutos</translation>
    </message>
    <message>
        <source>The first steps on a sample, one after another.</source>
        <translation>Los primeros pasos con un ejemplo, uno tras otro.</translation>
    </message>
    <message>
        <source>Not saved when Wend ended</source>
        <translation>Sin guardar cuando Wend terminó</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Descartar…</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Descartar %1</translation>
    </message>
    <message>
        <source>Deletes these changes for good.</source>
        <translation>Olvida estos cambios para siempre.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.
PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too.</source>
        <translation>PNG, JPEG, TIFF, EXR, WebP…: mejor recortadas y con transparencia.
PSD, ORA, KRA y SVG con sus capas. También proyectos, mallas y sólidos.</translation>
    </message>
</context>
<context>
    <name>wend::StatusFields</name>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Where the pointer is, in the picture&apos;s pixels</source>
        <translation>Dónde está el puntero, en píxeles de la imagen</translation>
    </message>
    <message>
        <source>Area change</source>
        <translation>Cambio de área</translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation>Cuánto mayor o menor es la forma que en reposo</translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation>área %1 %</translation>
    </message>
    <message>
        <source>volume %1 %</source>
        <translation>volumen %1 %</translation>
    </message>
</context>
<context>
    <name>wend::SurfaceCheck</name>
    <message>
        <source>Triangles with missing points</source>
        <translation>Triángulos con puntos ausentes</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>Triángulos que se cruzan</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>Edges of more than two</source>
        <translation>Aristas con más de dos triángulos</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>Triángulos sin área</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>Triángulos duplicados</translation>
    </message>
    <message>
        <source>Turned neighbours</source>
        <translation>Vecinos invertidos</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>Todos los puntos están en un mismo plano.</translation>
    </message>
    <message>
        <source>Save List</source>
        <translation>Guardar lista</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texto (*.txt)</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>Reparar superficie</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Crear jaula</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Solo superficie exacta</translation>
    </message>
    <message>
        <source>merge points (%1)</source>
        <translation>unir puntos (%1)</translation>
    </message>
    <message>
        <source>drop triangles (%1)</source>
        <translation>eliminar triángulos (%1)</translation>
    </message>
    <message>
        <source>turn triangles (%1)</source>
        <translation>voltear triángulos (%1)</translation>
    </message>
    <message>
        <source>fill holes (%1)</source>
        <translation>tapar huecos (%1)</translation>
    </message>
    <message>
        <source>It would %1.</source>
        <translation>Operaciones previstas: %1.</translation>
    </message>
    <message>
        <source>No simple step fixes this one.</source>
        <translation>Ningún paso sencillo corrige este fallo.</translation>
    </message>
    <message>
        <source>add triangles (%1)</source>
        <translation>añadir triángulos (%1)</translation>
    </message>
    <message>
        <source>It would leave %1 of %2 faults.</source>
        <translation>Quedarían %1 de %2 fallos.</translation>
    </message>
    <message>
        <source>Fix one fault</source>
        <translation>Corregir un fallo</translation>
    </message>
    <message>
        <source>No simple steps fix all of these.</source>
        <translation>Ningún paso sencillo los corrige todos.</translation>
    </message>
    <message>
        <source>Fix all faults of a kind</source>
        <translation>Corregir todos los fallos de un tipo</translation>
    </message>
    <message>
        <source>Looking for what fixes all of these …</source>
        <translation>Buscando cómo corregirlos todos…</translation>
    </message>
</context>
<context>
    <name>wend::SurfacePanel</name>
    <message>
        <source>Show them</source>
        <translation>Mostrarlos</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>Guardar lista…</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparar</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>The kinds of faults, and how often each occurs.</source>
        <translation>Los tipos de defectos y cuántas veces aparece cada uno.</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>Lugar anterior</translation>
    </message>
    <message>
        <source>Goes to the previous place where this is wrong.</source>
        <translation>Va al lugar anterior donde hay este defecto.</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>Lugar siguiente</translation>
    </message>
    <message>
        <source>Goes to the next place where this is wrong.</source>
        <translation>Va al lugar siguiente donde hay este defecto.</translation>
    </message>
    <message>
        <source>Show the triangles</source>
        <translation>Mostrar los triángulos</translation>
    </message>
    <message>
        <source>Colours the triangles that are wrong and shows them: what hides them is left out.</source>
        <translation>Colorea los triángulos defectuosos y los muestra: lo que los tapa se omite.</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Guardar la lista</translation>
    </message>
    <message>
        <source>Writes the numbers of all wrong triangles and edges to a file.</source>
        <translation>Escribe en un archivo los números de todos los triángulos y aristas defectuosos.</translation>
    </message>
    <message>
        <source>Merges coincident points, drops degenerate and duplicate triangles, orients the others and fills small holes.</source>
        <translation>Une los puntos coincidentes, elimina triángulos degenerados y duplicados, los orienta y tapa los huecos pequeños.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The surface is embedded in a cage</source>
        <translation>Una jaula lleva la superficie</translation>
    </message>
    <message>
        <source>The surface bounds no solid</source>
        <translation>La superficie no encierra ningún sólido</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>“Repair” helps.</source>
        <translation>«Reparar» lo soluciona.</translation>
    </message>
    <message>
        <source>“Repair” does not help: a cage around it can carry it.</source>
        <translation>«Reparar» no lo soluciona: una jaula a su alrededor puede llevarla.</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Solo superficie exacta</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Crear jaula</translation>
    </message>
    <message>
        <source>Removes the cage: without a repair there is then no solid.</source>
        <translation>Quita la jaula: sin reparar, entonces no hay sólido.</translation>
    </message>
    <message>
        <source>Fills a cage of even cells around the surface, which is embedded in it.</source>
        <translation>Rellena una jaula de celdas uniformes en torno a la superficie, a la que lleva consigo.</translation>
    </message>
    <message>
        <source>See the repair</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Shows the surface as the repair would leave it: what it adds in green, what stays wrong in red.</source>
        <translation>Muestra la superficie tal como la dejaría la reparación: en verde lo que añade, en rojo lo que sigue mal.</translation>
    </message>
    <message>
        <source>There is nothing that the simple repairs would change.</source>
        <translation>No hay nada que las reparaciones simples fueran a cambiar.</translation>
    </message>
    <message>
        <source>Fix this one</source>
        <translation>Corregir este</translation>
    </message>
    <message>
        <source>Fixes only what is shown: what it adds is green, what it takes away or turns is yellow.</source>
        <translation>Corrige solo lo que se mira: lo que añade es verde; lo que quita o gira, amarillo.</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>Corregir todos</translation>
    </message>
    <message>
        <source>Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no more edges than chosen below.</source>
        <translation>Corrige todos los de este tipo que unos pasos sencillos puedan corregir, en un solo paso que se puede deshacer; de los agujeros, los que no tengan más bordes que los elegidos abajo.</translation>
    </message>
    <message>
        <source>“Repair” does not help: the cage carries the surface as it is.</source>
        <translation>«Reparar» no lo soluciona: la jaula lleva la superficie tal como está.</translation>
    </message>
    <message>
        <source>One hole has %1 edges: fill up to %1</source>
        <translation>Un agujero tiene %1 aristas: rellenar hasta %1</translation>
    </message>
    <message>
        <source>%1 holes have up to %2 edges: fill up to %2</source>
        <translation>%1 agujeros tienen hasta %2 aristas: rellenar hasta %2</translation>
    </message>
    <message>
        <source>No hole is larger</source>
        <translation>Ningún agujero es mayor</translation>
    </message>
    <message>
        <source>Sets the largest hole that the repair fills to this.</source>
        <translation>Fija en esto el mayor agujero que rellena la reparación.</translation>
    </message>
</context>
<context>
    <name>wend::TimeRuler</name>
    <message>
        <source>Ruler</source>
        <translation>Regla</translation>
    </message>
    <message>
        <source>Drag to show another time; with Shift, mark the part that a loop repeats. A right-click counts frames, sets the frame rate, and adds markers</source>
        <translation>Arrastrar muestra otro momento; con Mayús marca la parte que repite un bucle. Un clic derecho cuenta fotogramas, fija la cadencia y añade marcas</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>Mover la marca</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Cambiar el ciclo</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Añadir marca</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marca</translation>
    </message>
    <message>
        <source>Rename Marker</source>
        <translation>Cambiar el nombre de la marca</translation>
    </message>
    <message>
        <source>Name of the marker:</source>
        <translation>Nombre de la marca:</translation>
    </message>
    <message>
        <source>Rename marker</source>
        <translation>Cambiar el nombre de la marca</translation>
    </message>
    <message>
        <source>Frame &amp;Rate</source>
        <translation>C&amp;adencia</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Cycle &amp;from Here</source>
        <translation>Ciclo &amp;desde aquí</translation>
    </message>
    <message>
        <source>Cycle &amp;to Here</source>
        <translation>Ciclo &amp;hasta aquí</translation>
    </message>
    <message>
        <source>&amp;No Cycle</source>
        <translation>&amp;Sin ciclo</translation>
    </message>
    <message>
        <source>Remove cycle</source>
        <translation>Quitar el ciclo</translation>
    </message>
    <message>
        <source>&amp;Count Frames</source>
        <translation>&amp;Contar fotogramas</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>Añadir &amp;marca</translation>
    </message>
    <message>
        <source>R&amp;ename Marker…</source>
        <translation>Cambiar el n&amp;ombre de la marca…</translation>
    </message>
    <message>
        <source>Re&amp;move Marker</source>
        <translation>&amp;Quitar la marca</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>Quitar la marca</translation>
    </message>
    <message>
        <source>Play the &amp;Sound</source>
        <translation>Reproducir el sonid&amp;o</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cycle: %1 to %2</source>
        <translation>Ciclo: %1 a %2</translation>
    </message>
    <message>
        <source>frames at %1 fps</source>
        <translation>fotogr., %1 fps</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>Show Key &amp;Poses</source>
        <translation>Mostrar las &amp;poses clave</translation>
    </message>
</context>
<context>
    <name>wend::TimeScale</name>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>wend::TimeStrip</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation>Qué momento del movimiento se muestra.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>How long the film is. The poses stay as they are, however fast it goes.</source>
        <translation>Lo que dura la película. Las poses no cambian, por rápida que vaya.</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>Cambiar duración</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Todavía no se mueve nada: arrastre un alfiler.</translation>
    </message>
    <message>
        <source>%1 /</source>
        <translation>%1 /</translation>
    </message>
    <message>
        <source>Drag a pin to begin</source>
        <translation>Arrastre un alfiler para empezar</translation>
    </message>
</context>
<context>
    <name>wend::Toolbox</name>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>What bends, and how finely</source>
        <translation>Qué se deforma y con qué finura</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Alfileres</translation>
    </message>
    <message>
        <source>Hold parts and drag them</source>
        <translation>Sujetar partes y arrastrarlas</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>What it is made of: soft, stiff, and what is kept where</source>
        <translation>De qué está hecho: blando, rígido y qué se conserva en cada sitio</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animar</translation>
    </message>
    <message>
        <source>How it moves in time</source>
        <translation>Cómo se mueve en el tiempo</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Abra primero una imagen.</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Abra primero un sólido.</translation>
    </message>
    <message>
        <source>Write pictures, sequences, ST maps and meshes</source>
        <translation>Exportar imágenes, secuencias, mapas ST y mallas</translation>
    </message>
</context>
<context>
    <name>wend::TrackChoice</name>
    <message>
        <source>Move in time</source>
        <translation>Mover en el tiempo</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>Eliminar movimiento</translation>
    </message>
    <message>
        <source>Remove motions</source>
        <translation>Quitar los movimientos</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Cambiar el suavizado</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplificar</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Mover claves</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Mover clave</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Eliminar claves</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Eliminar clave</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Pegar claves</translation>
    </message>
    <message>
        <source>Mirror keys</source>
        <translation>Reflejar claves</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Mantener</translation>
    </message>
    <message>
        <source>Nothing changes: where a pin begins it is at rest, and rotations keep their course.</source>
        <translation>Nada cambia: donde un pin empieza está en reposo, y las rotaciones conservan su curso.</translation>
    </message>
</context>
<context>
    <name>wend::TrackView</name>
    <message>
        <source>Rotate</source>
        <translation>Rotar</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escalar</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistas</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Mover en el tiempo</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>Cambiar la duración</translation>
    </message>
    <message>
        <source>&amp;Remove Motion</source>
        <translation>&amp;Eliminar movimiento</translation>
    </message>
    <message>
        <source>Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears here, pin by pin.</source>
        <translation>Todavía no se mueve nada. Arrastre un alfiler, o grábelo con Ctrl: lo que haga estará aquí, alfiler por alfiler.</translation>
    </message>
    <message>
        <source>Change when it holds</source>
        <translation>Cambiar cuándo sujeta</translation>
    </message>
    <message>
        <source>&amp;Remove Motions</source>
        <translation>&amp;Quitar los movimientos</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>&amp;Paste at the Time Shown</source>
        <translation>&amp;Pegar en el momento mostrado</translation>
    </message>
    <message>
        <source>Paste M&amp;irrored</source>
        <translation>Pegar refle&amp;jado</translation>
    </message>
    <message>
        <source>&amp;Straighten</source>
        <translation>&amp;Enderezar</translation>
    </message>
    <message>
        <source>Simplify to &amp;Keys</source>
        <translation>Simplificar a &amp;claves</translation>
    </message>
    <message>
        <source>&amp;Few</source>
        <translation>&amp;Pocas</translation>
    </message>
    <message>
        <source>&amp;Some</source>
        <translation>&amp;Algunas</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>&amp;Muchas</translation>
    </message>
    <message>
        <source>Key at %1</source>
        <translation>Clave: %1</translation>
    </message>
    <message>
        <source>Holds from %1 to %2</source>
        <translation>Sujeta de %1 a %2</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4</source>
        <translation>%1: %2 a %3, %4</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Lineal</translation>
    </message>
    <message>
        <source>Slow &amp;before It</source>
        <translation>Lento a&amp;ntes</translation>
    </message>
    <message>
        <source>Slow &amp;after It</source>
        <translation>Lento &amp;después</translation>
    </message>
    <message>
        <source>Slow on B&amp;oth Sides</source>
        <translation>Lento a am&amp;bos lados</translation>
    </message>
    <message>
        <source>&amp;Hold to the Next</source>
        <translation>Mantener &amp;hasta la siguiente</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Re&amp;flejar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Remove Keys</source>
        <translation>&amp;Eliminar claves</translation>
    </message>
    <message>
        <source>&amp;Remove Key</source>
        <translation>&amp;Eliminar clave</translation>
    </message>
    <message>
        <source>A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right another time, with Alt they move the chosen bar or keys</source>
        <translation>Una fila por alfiler, una barra por movimiento; Arriba y Abajo eligen un alfiler, Izquierda y Derecha otro momento, con Alt mueven la barra o las claves elegidas</translation>
    </message>
    <message>
        <source>Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds</source>
        <translation>Arrastre una clave (un rombo) o una barra a otro momento; Mayús, Ctrl o un marco alrededor eligen varias. Un clic derecho suaviza, mantiene, copia, refleja. Los extremos de la línea dicen cuándo sujeta el pin</translation>
    </message>
    <message>
        <source>Easing Curve</source>
        <translation>Curva de suavizado</translation>
    </message>
    <message>
        <source>Easing C&amp;urve…</source>
        <translation>C&amp;urva de suavizado…</translation>
    </message>
</context>
<context>
    <name>wend::Tutorial</name>
    <message>
        <source>End</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Ends the tutorial; the picture stays open</source>
        <translation>Termina el tutorial; la imagen sigue abierta</translation>
    </message>
    <message>
        <source>Only what is pinned holds. &lt;b&gt;Click a hoof&lt;/b&gt; of the giraffe to pin it.</source>
        <translation>Solo queda fijo lo que tiene un alfiler. &lt;b&gt;Haga clic en una pezuña&lt;/b&gt; de la jirafa para poner uno.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pin the other hooves&lt;/b&gt;, too, with a click each. Ctrl+Z undoes a pin.</source>
        <translation>&lt;b&gt;Ponga alfileres también en las otras pezuñas&lt;/b&gt;, con un clic en cada una. Ctrl+Z deshace un alfiler.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click its nose&lt;/b&gt;, and &lt;b&gt;drag the new pin&lt;/b&gt; down to the ground. The shape flows along.</source>
        <translation>&lt;b&gt;Haga clic en el hocico&lt;/b&gt; y &lt;b&gt;arrastre el nuevo alfiler&lt;/b&gt; hasta el suelo. La forma lo acompaña con fluidez.</translation>
    </message>
    <message>
        <source>What it keeps on the way is your choice: at the top right, under &lt;b&gt;Keep&lt;/b&gt;, &lt;b&gt;choose Area, Rigid or Angle&lt;/b&gt;, and see the neck change.</source>
        <translation>Usted decide qué conserva por el camino: arriba a la derecha, en &lt;b&gt;Conservar&lt;/b&gt;, &lt;b&gt;elija Área, Rígido o Ángulo&lt;/b&gt; y vea cómo cambia el cuello.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press D&lt;/b&gt; to see in colours what the bend has changed, and where most. D again hides it.</source>
        <translation>&lt;b&gt;Pulse D&lt;/b&gt; para ver en colores qué ha cambiado la deformación, y dónde más. D otra vez lo oculta.</translation>
    </message>
    <message>
        <source>The same for a part only: &lt;b&gt;press Ctrl+3&lt;/b&gt; for the step &lt;i&gt;Paint&lt;/i&gt;, and &lt;b&gt;brush over the neck&lt;/b&gt;. [ and ] change the size of the brush.</source>
        <translation>Lo mismo solo para una parte: &lt;b&gt;pulse Ctrl+3&lt;/b&gt; para el paso &lt;i&gt;Pintar&lt;/i&gt; y &lt;b&gt;pase el pincel por el cuello&lt;/b&gt;. [ y ] cambian el tamaño del pincel.</translation>
    </message>
    <message>
        <source>Your drag is already a film: &lt;b&gt;press K&lt;/b&gt; to play it. Click into the strip below to go to a time, and drag on from there.</source>
        <translation>Lo que ha arrastrado ya es una película: &lt;b&gt;pulse K&lt;/b&gt; para reproducirla. Haga clic en la franja de abajo para ir a un momento y siga arrastrando desde ahí.</translation>
    </message>
    <message>
        <source>That is all you need to begin. &lt;b&gt;F1&lt;/b&gt; opens the manual, &lt;b&gt;?&lt;/b&gt; lists the keys. Drop a picture of your own on the window.</source>
        <translation>Es todo lo que necesita para empezar. &lt;b&gt;F1&lt;/b&gt; abre el manual, &lt;b&gt;?&lt;/b&gt; muestra las teclas. Suelte una imagen suya en la ventana.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Finally, &lt;b&gt;press Ctrl+5&lt;/b&gt; for the step &lt;i&gt;Export&lt;/i&gt;: a picture, a sequence, an ST map, or the mesh.</source>
        <translation>Por último, &lt;b&gt;pulse Ctrl+5&lt;/b&gt; para el paso &lt;i&gt;Exportar&lt;/i&gt;: una imagen, una secuencia, un mapa ST o la malla.</translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation>Vista del sólido</translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation>No se puede dibujar el sólido: %1</translation>
    </message>
</context>
<context>
    <name>wend::WorkNote</name>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Cancelar (Esc)</translation>
    </message>
    <message>
        <source>Stops what is being computed and goes back to the last complete state</source>
        <translation>Detiene el cálculo en curso y vuelve al último estado completo</translation>
    </message>
    <message>
        <source>Computing the motion: %1 %</source>
        <translation>Calculando el movimiento: %1 %</translation>
    </message>
    <message>
        <source>Meshing %1 …</source>
        <translation>Mallando %1…</translation>
    </message>
    <message numerus="yes">
        <source>Meshing %1 with about %Ln vertices …</source>
        <translation>
            <numerusform>Mallando %1 con unos %Ln vértices…</numerusform>
            <numerusform>Mallando %1 con unos %Ln vértices…</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Filling the ground behind “%1” …</source>
        <translation>Rellenando el fondo detrás de «%1»…</translation>
    </message>
</context>
</TS>
