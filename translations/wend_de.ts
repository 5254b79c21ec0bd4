<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>CheatSheet</name>
    <message>
        <source>Pointer</source>
        <translation>Zeiger</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klicken</translation>
    </message>
    <message>
        <source>sets a pin</source>
        <translation>setzt einen Pin</translation>
    </message>
    <message>
        <source>Drag a pin</source>
        <translation>Pin ziehen</translation>
    </message>
    <message>
        <source>moves it; Esc puts it back</source>
        <translation>bewegt ihn; Esc setzt ihn zurück</translation>
    </message>
    <message>
        <source>Shift-click</source>
        <translation>Umschalt-Klick</translation>
    </message>
    <message>
        <source>selects several pins</source>
        <translation>wählt mehrere Pins</translation>
    </message>
    <message>
        <source>Digits while dragging</source>
        <translation>Ziffern beim Ziehen</translation>
    </message>
    <message>
        <source>set the number; Enter confirms it</source>
        <translation>setzen die Zahl, Eingabe übernimmt sie</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>zooms to the pointer</source>
        <translation>zoomt zum Zeiger</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ und ]</translation>
    </message>
    <message>
        <source>size of a brush</source>
        <translation>Größe eines Pinsels</translation>
    </message>
    <message>
        <source>Hold H</source>
        <translation>H halten</translation>
    </message>
    <message>
        <source>Hold \</source>
        <translation>\ halten</translation>
    </message>
    <message>
        <source>shows the shape before it was bent</source>
        <translation>zeigt die Form vor dem Biegen</translation>
    </message>
    <message>
        <source>X, Y, Z while dragging</source>
        <translation>X, Y, Z beim Ziehen</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>halten eine Achse fest</translation>
    </message>
    <message>
        <source>Right or middle button</source>
        <translation>Rechte oder mittlere Taste</translation>
    </message>
    <message>
        <source>turns the view; with Shift, moves it</source>
        <translation>dreht die Ansicht; mit Umschalt verschiebt sie</translation>
    </message>
    <message>
        <source>Middle click</source>
        <translation>Mittelklick</translation>
    </message>
    <message>
        <source>sets the point to turn around</source>
        <translation>setzt den Punkt, um den gedreht wird</translation>
    </message>
    <message>
        <source>widens it to a circle</source>
        <translation>weitet ihn zu einem Kreis</translation>
    </message>
    <message>
        <source>Drag the ring&apos;s dot or square</source>
        <translation>Punkt oder Quadrat des Rings ziehen</translation>
    </message>
    <message>
        <source>rotates or scales; Shift snaps to 15°</source>
        <translation>dreht oder skaliert; Umschalt rastet bei 15° ein</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>nudge by a pixel, with Shift by ten</source>
        <translation>rücken um ein Pixel, mit Umschalt um zehn</translation>
    </message>
    <message>
        <source>pans</source>
        <translation>verschiebt die Ansicht</translation>
    </message>
    <message>
        <source>Shift-click with the brush</source>
        <translation>Klick mit Umschalt beim Malen</translation>
    </message>
    <message>
        <source>paints a straight line</source>
        <translation>malt eine gerade Linie</translation>
    </message>
    <message>
        <source>Arrow keys without a pin</source>
        <translation>Pfeiltasten ohne Pin</translation>
    </message>
    <message>
        <source>move a cross, Enter clicks there</source>
        <translation>bewegen ein Kreuz, Eingabe klickt dort</translation>
    </message>
    <message>
        <source>Alt-right-drag a brush</source>
        <translation>Rechts mit Alt ziehen, beim Malen</translation>
    </message>
    <message>
        <source>changes its size and hardness</source>
        <translation>ändert Größe und Härte</translation>
    </message>
    <message>
        <source>Tap the space bar</source>
        <translation>Leertaste antippen</translation>
    </message>
    <message>
        <source>plays or pauses; held, it moves the view</source>
        <translation>spielt ab oder hält an; gehalten verschiebt sie die Ansicht</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Taste</translation>
    </message>
    <message>
        <source>hides pins and overlays</source>
        <translation>blendet Pins und Überlagerungen aus</translation>
    </message>
    <message>
        <source>Ctrl+Shift-drag a pin</source>
        <translation>Einen Pin mit Strg+Umschalt ziehen</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Auf, Ab</translation>
    </message>
    <message>
        <source>choose a pin</source>
        <translation>wählen einen Pin</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>show another time</source>
        <translation>zeigen eine andere Zeit</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Links, Alt+Rechts</translation>
    </message>
    <message>
        <source>move the chosen bars or keys</source>
        <translation>verschieben die gewählten Balken oder Schlüsselposen</translation>
    </message>
    <message>
        <source>Shift-click, or a frame</source>
        <translation>Umschalt-Klick oder ein Rahmen</translation>
    </message>
    <message>
        <source>chooses several</source>
        <translation>wählt mehrere</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>opens their easing curve</source>
        <translation>öffnet deren Easing-Kurve</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Strg+C, Strg+V</translation>
    </message>
    <message>
        <source>copy keys, paste them at the time shown</source>
        <translation>kopieren Schlüsselposen und fügen sie zur gezeigten Zeit ein</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Strg+Umschalt+V</translation>
    </message>
    <message>
        <source>pastes them mirrored</source>
        <translation>fügt sie gespiegelt ein</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>entfernt sie</translation>
    </message>
    <message>
        <source>I, O</source>
        <translation>I, O</translation>
    </message>
    <message>
        <source>begin and end the cycle here</source>
        <translation>beginnen und beenden hier den Zyklus</translation>
    </message>
    <message>
        <source>Shift-drag the numbers</source>
        <translation>Zahlen mit Umschalt ziehen</translation>
    </message>
    <message>
        <source>marks the cycle</source>
        <translation>markiert den Zyklus</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Umschalt+M</translation>
    </message>
    <message>
        <source>adds a marker</source>
        <translation>setzt eine Marke</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>at time %1 %2 cannot go on: %3</source>
        <translation>zur Zeit %1 kann %2 nicht weiter: %3</translation>
    </message>
    <message>
        <source>at time %1 the shape is too stiff to settle further near %2: the steps would be too short; allow a larger tolerance</source>
        <translation>zur Zeit %1 ist die Form bei %2 zu steif, um sich weiter zu setzen: Die Schritte würden zu kurz; eine größere Toleranz hilft</translation>
    </message>
    <message>
        <source>the shape would fold over near %1, in cell %2; move it less far or along another path, or release what holds the shape there</source>
        <translation>die Form würde sich bei %1, in Zelle %2, überschlagen; weniger weit oder anders führen, oder lösen, was die Form dort hält</translation>
    </message>
    <message>
        <source>the shape would fold over near %1; move it less far or along another path, or release what holds the shape there</source>
        <translation>die Form würde sich bei %1 überschlagen; weniger weit oder anders führen, oder lösen, was die Form dort hält</translation>
    </message>
    <message>
        <source>it moves too fast near %1: the steps would be too short; give its motion more time, or allow a larger tolerance</source>
        <translation>bei %1 ist es zu schnell, die Schritte würden zu kurz; der Bewegung mehr Zeit geben oder eine größere Toleranz erlauben</translation>
    </message>
    <message>
        <source>the shape near %1 is stretched or squeezed so much that no velocity can be computed; move it less far, or make the material or the mesh more even there</source>
        <translation>die Form ist bei %1 so gedehnt oder gestaucht, dass sich keine Geschwindigkeit berechnen lässt; weniger weit führen, oder Material oder Netz dort gleichmäßiger machen</translation>
    </message>
    <message>
        <source>it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time</source>
        <translation>bei %1 ist es so schnell, dass Zahlen überlaufen; weniger weit führen oder der Bewegung mehr Zeit geben</translation>
    </message>
    <message>
        <source>the shape needs about %1 of memory; %2 are free; fewer vertices need less</source>
        <translation>die Form braucht etwa %1 Speicher; %2 sind frei; weniger Ecken brauchen weniger</translation>
    </message>
    <message>
        <source>%1 and %2 move the point %3 in different ways at time %4</source>
        <translation>%1 und %2 bewegen den Punkt %3 zur Zeit %4 verschieden</translation>
    </message>
    <message>
        <source>handle &quot;%1&quot;</source>
        <translation>Pin „%1“</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>Pin %1</translation>
    </message>
    <message>
        <source>the shape</source>
        <translation>die Form</translation>
    </message>
    <message>
        <source>its region holds no vertex</source>
        <translation>in seinem Bereich liegt kein Eckpunkt</translation>
    </message>
    <message>
        <source>vertex %1 belongs to no cell</source>
        <translation>Eckpunkt %1 gehört zu keiner Zelle</translation>
    </message>
    <message>
        <source>the picture has no alpha channel to take an outline from</source>
        <translation>das Bild hat keinen Alphakanal, aus dem ein Umriss werden könnte</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>das Bild hat keine Pixel</translation>
    </message>
    <message>
        <source>no part of the picture is as large as %1 pixels</source>
        <translation>kein Teil des Bilds ist so groß wie %1 Pixel</translation>
    </message>
    <message>
        <source>the picture is fully transparent</source>
        <translation>das Bild ist ganz durchsichtig</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha is nowhere above the threshold of %1 %</source>
        <translation>die Deckkraft des Bilds liegt nirgends über der Schwelle von %1 %</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha has too many contours: it looks like noise</source>
        <translation>der Alphakanal hat zu viele Konturen: Er sieht nach Rauschen aus</translation>
    </message>
    <message>
        <source>the outline is empty</source>
        <translation>der Umriss ist leer</translation>
    </message>
    <message>
        <source>the outline crosses or overlaps itself near %1</source>
        <translation>der Umriss kreuzt oder überdeckt sich bei %1</translation>
    </message>
    <message>
        <source>the outline cannot be triangulated (%1)</source>
        <translation>der Umriss lässt sich nicht triangulieren (%1)</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same, %3</source>
        <translation>die Punkte %1 und %2 sind derselbe, %3</translation>
    </message>
    <message>
        <source>point %1, %2, is outside the shape</source>
        <translation>Punkt %1, %2, liegt außerhalb der Form</translation>
    </message>
    <message>
        <source>an edge length of %1 would take more than %2 vertices</source>
        <translation>eine Kantenlänge von %1 bräuchte mehr als %2 Eckpunkte</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>existiert nicht</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>ist eine Pipe, keine Datei</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>ist ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>is a symbolic link that leads back to itself</source>
        <translation>ist ein symbolischer Link, der zu sich selbst führt</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>der Datenträger ist vielleicht voll</translation>
    </message>
    <message>
        <source>the disk is full, only %1 are free</source>
        <translation>der Datenträger ist voll, nur %1 sind frei</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>der Ordner %1 existiert nicht</translation>
    </message>
    <message>
        <source>the folder %1 is not writable</source>
        <translation>in den Ordner %1 darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>is read-only: make it writable first, or choose another name</source>
        <translation>ist schreibgeschützt: erst beschreibbar machen oder einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>is a model or a mesh of a kind that is not read (%1); these are: %2</source>
        <translation>ist ein Modell oder Netz einer Art, die nicht gelesen wird (%1); gelesen werden: %2</translation>
    </message>
    <message>
        <source>a JPEG XL picture</source>
        <translation>ein JPEG-XL-Bild</translation>
    </message>
    <message>
        <source>a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)</source>
        <translation>ein GIMP-Bild (XCF; aus GIMP als PNG oder OpenRaster exportieren)</translation>
    </message>
    <message>
        <source>has a layer &quot;%1&quot; with an opacity out of range: it is limited to 0 … 100 %</source>
        <translation>hat eine Ebene „%1“ mit einer unmöglichen Deckkraft: sie wird auf 0 … 100 % begrenzt</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a film</source>
        <translation>ein Film</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ein ZIP-Archiv</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>eine Textdatei</translation>
    </message>
    <message>
        <source>not a picture that Wend knows</source>
        <translation>kein Bild, das Wend kennt</translation>
    </message>
    <message>
        <source>cannot be read as a picture: %1</source>
        <translation>kann nicht als Bild gelesen werden: %1</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>hat keine Pixel</translation>
    </message>
    <message>
        <source>is a volume, not a picture</source>
        <translation>ist ein Volumen, kein Bild</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than %3 million</source>
        <translation>hat %1 × %2 Pixel, mehr als %3 Millionen</translation>
    </message>
    <message>
        <source>is truncated or corrupt</source>
        <translation>ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>is transparent everywhere</source>
        <translation>ist überall durchsichtig</translation>
    </message>
    <message>
        <source>holds tetrahedra, but the project is in the plane</source>
        <translation>enthält Tetraeder, aber das Projekt ist eben</translation>
    </message>
    <message>
        <source>holds no tetrahedra, but the project is in space</source>
        <translation>enthält keine Tetraeder, aber das Projekt ist räumlich</translation>
    </message>
    <message>
        <source>the surface has no triangle</source>
        <translation>die Oberfläche hat kein Dreieck</translation>
    </message>
    <message>
        <source>the surface has no extent</source>
        <translation>die Oberfläche hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>die Oberfläche umschließt kein Volumen</translation>
    </message>
    <message>
        <source>the surface bounds no volume: %1</source>
        <translation>die Oberfläche begrenzt kein Volumen: %1</translation>
    </message>
    <message>
        <source>the surface intersects itself</source>
        <translation>die Oberfläche schneidet sich selbst</translation>
    </message>
    <message>
        <source>the surface has features too small for its size</source>
        <translation>die Oberfläche hat für ihre Größe zu feine Einzelheiten</translation>
    </message>
    <message>
        <source>two facets of the surface lie almost on each other</source>
        <translation>zwei Flächen der Oberfläche liegen fast aufeinander</translation>
    </message>
    <message>
        <source>the volume mesher ran out of memory</source>
        <translation>beim Füllen mit Tetraedern ging der Speicher aus</translation>
    </message>
    <message>
        <source>the volume mesher did not finish within %1 s of computing; a coarser quality or a larger maxVolume may help</source>
        <translation>das Füllen mit Tetraedern war nach %1 s Rechnen nicht fertig; eine gröbere Qualität oder größere Tetraeder helfen vielleicht</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>alle Punkte liegen in einer Ebene</translation>
    </message>
    <message>
        <source>%1 open edge (first: %2)</source>
        <translation>%1 offene Kante (%2)</translation>
    </message>
    <message>
        <source>%1 open edges (first: %2)</source>
        <translation>%1 offene Kanten (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 edge of more than two triangles (first: %2)</source>
        <translation>%1 Kante mit mehr als zwei Dreiecken (%2)</translation>
    </message>
    <message>
        <source>%1 edges of more than two triangles (first: %2)</source>
        <translation>%1 Kanten mit mehr als zwei Dreiecken (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 pair of triangles that intersect (first: %2)</source>
        <translation>%1 Paar sich schneidender Dreiecke (%2)</translation>
    </message>
    <message>
        <source>%1 pairs of triangles that intersect (first: %2)</source>
        <translation>%1 Paare sich schneidender Dreiecke (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 triangle without area (first: %2)</source>
        <translation>%1 Dreieck ohne Fläche (%2)</translation>
    </message>
    <message>
        <source>%1 triangles without area (first: %2)</source>
        <translation>%1 Dreiecke ohne Fläche (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangle (first: %2)</source>
        <translation>%1 doppeltes Dreieck (%2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangles (first: %2)</source>
        <translation>%1 doppelte Dreiecke (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 edge where the orientation changes (first: %2)</source>
        <translation>%1 Kante, an der die Orientierung wechselt (%2)</translation>
    </message>
    <message>
        <source>%1 edges where the orientation changes (first: %2)</source>
        <translation>%1 Kanten, an denen die Orientierung wechselt (zuerst %2)</translation>
    </message>
    <message>
        <source>the surface was repaired: %1</source>
        <translation>die Oberfläche wurde repariert: %1</translation>
    </message>
    <message>
        <source>%1 coincident vertex merged</source>
        <translation>%1 zusammenfallender Eckpunkt vereint</translation>
    </message>
    <message>
        <source>%1 coincident vertices merged</source>
        <translation>%1 zusammenfallende Eckpunkte vereint</translation>
    </message>
    <message>
        <source>%1 triangle without area dropped</source>
        <translation>%1 Dreieck ohne Fläche entfernt</translation>
    </message>
    <message>
        <source>%1 triangles without area dropped</source>
        <translation>%1 Dreiecke ohne Fläche entfernt</translation>
    </message>
    <message>
        <source>%1 duplicate triangle dropped</source>
        <translation>%1 doppeltes Dreieck entfernt</translation>
    </message>
    <message>
        <source>%1 duplicate triangles dropped</source>
        <translation>%1 doppelte Dreiecke entfernt</translation>
    </message>
    <message>
        <source>%1 triangle turned over</source>
        <translation>%1 Dreieck umgedreht</translation>
    </message>
    <message>
        <source>%1 triangles turned over</source>
        <translation>%1 Dreiecke umgedreht</translation>
    </message>
    <message>
        <source>%1 hole filled</source>
        <translation>%1 Loch gefüllt</translation>
    </message>
    <message>
        <source>%1 holes filled</source>
        <translation>%1 Löcher gefüllt</translation>
    </message>
    <message>
        <source>the surface is embedded in a cage of %1 vertices, since %2</source>
        <translation>die Oberfläche ist in einen Käfig aus %1 Eckpunkten eingebettet, denn %2</translation>
    </message>
    <message>
        <source>it cannot be meshed as it is: %1</source>
        <translation>so, wie sie ist, lässt sie sich nicht vernetzen: %1</translation>
    </message>
    <message>
        <source>it has %1 vertices, where %2 were aimed at</source>
        <translation>sie hat %1 Eckpunkte, wo %2 angestrebt waren</translation>
    </message>
    <message>
        <source>the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer</source>
        <translation>der Käfig hat %1 Eckpunkte, wo %2 angestrebt waren: Näher kommen ganze Würfel nicht heran</translation>
    </message>
    <message>
        <source>the cells of the cage are larger than asked for: there is no memory for smaller ones</source>
        <translation>die Zellen des Käfigs sind größer als gewünscht: Für kleinere reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>sizes are for the exact surface: a cage has cells of one size</source>
        <translation>Größen gelten für die genaue Oberfläche: Ein Käfig hat Zellen einer Größe</translation>
    </message>
    <message>
        <source>its %1 parts share cells of the cage and move together as %2: smaller cells keep more of them apart</source>
        <translation>ihre %1 Teile teilen sich Zellen des Käfigs und bewegen sich gemeinsam als %2: Kleinere Zellen halten mehr von ihnen getrennt</translation>
    </message>
    <message>
        <source>the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow</source>
        <translation>der Käfig besteht aus %1 Körpern, die nicht zusammenhängen: Jeder braucht einen eigenen Pin, um zu folgen</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie outside the solid that carries them</source>
        <translation>%1 von %2 Eckpunkten liegen außerhalb des Körpers, der sie trägt</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them</source>
        <translation>das Netz hat %1 Eckpunkte, wo %2 angestrebt waren: Die gewünschte Qualität braucht sie</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is</source>
        <translation>das Netz hat %1 Eckpunkte, wo %2 angestrebt waren: Die Oberfläche bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>the surface&apos;s triangles are far larger than the cells inside and are kept as they are, which makes uneven cells</source>
        <translation>die Dreiecke der Oberfläche sind weit größer als die Zellen innen und bleiben, wie sie sind; das macht ungleichmäßige Zellen</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell is above it)</source>
        <translation>die schlechteste Zelle hat ein Verhältnis von Radius zu Kante von %1, gewünscht war %2 (%3 Zelle liegt darüber)</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells are above it)</source>
        <translation>die schlechteste Zelle hat ein Verhältnis von Radius zu Kante von %1, gewünscht war %2 (%3 Zellen liegen darüber)</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2</source>
        <translation>%1: Die Oberfläche bleibt, wie sie ist, und erzwingt es an ihren Dreiecken %2</translation>
    </message>
    <message>
        <source>%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written without them, so that later vertices have other numbers</source>
        <translation>%1 Eckpunkte der Oberfläche gehören zu keinem Tetraeder: Netze aus Tetraedern werden ohne sie geschrieben, und dahinter mit anderen Nummern</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 Eckpunkte gehören zu keiner Zelle. Sie bleiben in dem, was geschrieben wird: Manche Löser wollen sie vorher entfernt haben</translation>
    </message>
    <message>
        <source>parts that touch vertex to vertex are connected: %1 vertices move with others at the same place</source>
        <translation>Teile, die sich Eckpunkt an Eckpunkt berühren, hängen zusammen: %1 Eckpunkte bewegen sich mit anderen an ihrer Stelle</translation>
    </message>
    <message>
        <source>a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away unless handles hold it</source>
        <translation>ein Teil aus %1 hängt allein an %2 bei %3: Was sich dort frei dreht, kann weit fortgeschleudert werden, wenn Pins es nicht halten</translation>
    </message>
    <message>
        <source>%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 Teile hängen nur an einem Eckpunkt oder einer Kante, das erste, aus %2, an %3 bei %4: Was sich dort frei dreht, kann weit fortgeschleudert werden, wenn Pins es nicht halten</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>%1 cell</source>
        <translation>%1 Zelle</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>the edge %1</source>
        <translation>der Kante %1</translation>
    </message>
    <message>
        <source>%1 single step</source>
        <translation>%1 einzelner Schritt</translation>
    </message>
    <message>
        <source>%1 single steps</source>
        <translation>%1 einzelne Schritte</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>es gibt kein Dreieck %1</translation>
    </message>
    <message>
        <source>no hole has the edge %1</source>
        <translation>kein Loch hat die Kante %1</translation>
    </message>
    <message>
        <source>the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves together</source>
        <translation>der Käfig schließt eine Lücke in einem Teil, %1 breit bei %2: Was auf beiden Seiten liegt, bewegt sich zusammen</translation>
    </message>
    <message>
        <source>the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on both sides moves together</source>
        <translation>der Käfig schließt %1 Lücken in einem Teil, die engste %2 breit bei %3: Was auf beiden Seiten liegt, bewegt sich zusammen</translation>
    </message>
    <message>
        <source>%1; about %2 vertices open the widest</source>
        <translation>%1; etwa %2 Knoten öffnen die weiteste</translation>
    </message>
    <message>
        <source>%1; cells of at most %2 open the widest</source>
        <translation>%1; Zellen von höchstens %2 öffnen die weiteste</translation>
    </message>
    <message>
        <source>%1; a detail of %2 opens the widest</source>
        <translation>%1; ein Detailgrad von %2 öffnet die weiteste</translation>
    </message>
    <message>
        <source>1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, so that later vertices have other numbers</source>
        <translation>1 Punkt der Oberfläche gehört zu keinem Tetraeder: Tetraedernetze werden ohne ihn geschrieben und haben dahinter andere Nummern</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 Punkt gehört zu keiner Zelle. Er bleibt in dem, was geschrieben wird: Manche Löser wollen ihn vorher entfernt haben</translation>
    </message>
    <message>
        <source>holds %1 points, but neither triangles nor tetrahedra between them: a surface has to be made of the points first, as MeshLab and CloudCompare do</source>
        <translation>enthält %1 Punkte, aber weder Dreiecke noch Tetraeder dazwischen: Aus den Punkten muss erst eine Oberfläche werden, etwa mit MeshLab oder CloudCompare</translation>
    </message>
    <message>
        <source>%1: its points have four coordinates; only points in space, which have three, are read</source>
        <translation>%1: Die Punkte haben vier Koordinaten; gelesen werden nur Punkte im Raum, die drei haben</translation>
    </message>
    <message>
        <source>the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells may help</source>
        <translation>der Käfig war nach %1 s Rechnen nicht fertig; weniger Eckpunkte oder größere Zellen helfen vielleicht</translation>
    </message>
    <message>
        <source>there is no memory for a cage of so many cells; fewer vertices or larger cells may help</source>
        <translation>für einen Käfig aus so vielen Zellen reicht der Speicher nicht; weniger Eckpunkte oder größere Zellen helfen vielleicht</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and about %3 vertices open the widest</source>
        <translation>%1; ein Detailgrad von %2 und etwa %3 Knoten öffnen die weiteste</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and cells of at most %3 open the widest</source>
        <translation>%1; ein Detailgrad von %2 und Zellen von höchstens %3 öffnen die weiteste</translation>
    </message>
    <message>
        <source>a list of points without a surface</source>
        <translation>eine Liste von Punkten ohne Oberfläche</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: its outline needs them</source>
        <translation>das Netz hat %1 Eckpunkte, wo %2 angestrebt waren: Sein Umriss braucht sie</translation>
    </message>
    <message>
        <source>is no project of Wend, which is JSON and begins with {</source>
        <translation>ist kein Projekt von Wend; die sind JSON und beginnen mit {</translation>
    </message>
    <message>
        <source>has %1 pictures (pages, frames or parts): the first one is read</source>
        <translation>enthält %1 Bilder (Seiten, Einzelbilder oder Teile): gelesen wird das erste</translation>
    </message>
    <message>
        <source>has channels that are left out: %1</source>
        <translation>hat Kanäle, die weggelassen werden: %1</translation>
    </message>
    <message>
        <source>has a channel of no declared kind after its colours: it is taken as alpha</source>
        <translation>hat nach den Farben einen Kanal ohne erklärte Art: er gilt als Alpha</translation>
    </message>
    <message>
        <source>reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off</source>
        <translation>reicht über sein Anzeigefenster von %1 x %2 Pixeln hinaus: was außerhalb liegt, wird abgeschnitten</translation>
    </message>
    <message>
        <source>has a colour profile that does not fit its colours: it is left out</source>
        <translation>hat ein Farbprofil, das nicht zu seinen Farben passt: es wird weggelassen</translation>
    </message>
    <message>
        <source>has a colour space that is not known (cICP %1): it is not kept</source>
        <translation>hat einen unbekannten Farbraum (cICP %1): er bleibt nicht erhalten</translation>
    </message>
    <message>
        <source>1 pixel is not a finite number (NaN or infinity), at x %1, y %2</source>
        <translation>1 Pixel ist keine endliche Zahl (NaN oder unendlich), bei x %1, y %2</translation>
    </message>
    <message>
        <source>%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3</source>
        <translation>%1 Pixel sind keine endlichen Zahlen (NaN oder unendlich), das erste bei x %2, y %3</translation>
    </message>
    <message>
        <source>is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures</source>
        <translation>ist %1. Wend öffnet PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, Kamera-Rohdaten und andere Bilder</translation>
    </message>
    <message>
        <source>its reader failed inside (signal %1)</source>
        <translation>das Leseprogramm ist abgestürzt (Signal %1)</translation>
    </message>
    <message>
        <source>its reader was ended (signal %1)</source>
        <translation>das Leseprogramm wurde beendet (Signal %1)</translation>
    </message>
    <message>
        <source>its reader failed (exit code %1)</source>
        <translation>das Leseprogramm ist gescheitert (Ende mit %1)</translation>
    </message>
    <message>
        <source>its reader has done nothing for %1 s</source>
        <translation>das Leseprogramm hat %1 s lang nichts getan</translation>
    </message>
    <message>
        <source>its reader has not come to an end</source>
        <translation>das Leseprogramm ist nicht fertig geworden</translation>
    </message>
    <message>
        <source>it needs more than the %1 MB of memory that reading may take</source>
        <translation>es braucht mehr als die %1 MB Speicher, die das Lesen belegen darf</translation>
    </message>
    <message>
        <source>has %1 layers: opened flattened</source>
        <translation>hat %1 Ebenen: zusammengefasst geöffnet</translation>
    </message>
    <message>
        <source>holds no picture of all its layers (%1): save it with one</source>
        <translation>enthält kein Bild aller Ebenen (%1): mit einem speichern</translation>
    </message>
    <message>
        <source>has a damaged %1</source>
        <translation>hat eine beschädigte Datei %1</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and %3 times more</source>
        <translation>zur Zeit %1 springt die Form nahe %2 in ein anderes Gleichgewicht, und noch %3 Mal</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2</source>
        <translation>zur Zeit %1 springt die Form nahe %2 in ein anderes Gleichgewicht</translation>
    </message>
    <message>
        <source>pins of the other project without a namesake here, placed in proportion: %1</source>
        <translation>Pins des anderen Projekts, die hier keinen Namensvetter haben und nach Verhältnis gesetzt sind: %1</translation>
    </message>
    <message>
        <source>pins of the other project that find no place here and are left out: %1</source>
        <translation>Pins des anderen Projekts, die hier keinen Platz finden und fehlen: %1</translation>
    </message>
    <message>
        <source>pins without a motion in the other project, which hold still: %1</source>
        <translation>Pins ohne Bewegung im anderen Projekt, die stillhalten: %1</translation>
    </message>
    <message>
        <source>moves a solid: its motion does not fit a picture</source>
        <translation>bewegt einen Körper: seine Bewegung passt nicht zu einem Bild</translation>
    </message>
    <message>
        <source>moves a picture: its motion does not fit a solid</source>
        <translation>bewegt ein Bild: seine Bewegung passt nicht zu einem Körper</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3</source>
        <translation>Schalen liegen ineinander, bis zu %1 tief; gefüllte Räume: %2, hohle: %3</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces filled: %2, hollow: %3</source>
        <translation>Schalen liegen ineinander, bis zu %1 tief, und Körper berühren sich an gemeinsamen Wänden; gefüllte Räume: %2, hohle: %3</translation>
    </message>
    <message>
        <source>bodies touch along shared walls; spaces filled: %1, hollow: %2</source>
        <translation>Körper berühren sich an gemeinsamen Wänden; gefüllte Räume: %1, hohle: %2</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled</source>
        <translation>%1 hat %2 × %3 Pixel, und das Projekt wurde für %4 × %5 gemacht: Pins und Wege sind angepasst</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where they are</source>
        <translation>%1 hat %2 × %3 Pixel, und das Projekt wurde für %4 × %5 gemacht: Pins und Wege bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>the project&apos;s picture is no SVG drawing: it has no paths that could be written</source>
        <translation>das Bild des Projekts ist keine SVG-Zeichnung: Es hat keine Pfade, die geschrieben werden könnten</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is no SVG drawing: it becomes a picture in the SVG file</source>
        <translation>der Teil „%1“ ist keine SVG-Zeichnung: In der SVG-Datei wird er ein Bild</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is cut: it becomes a picture in the SVG file</source>
        <translation>der Teil „%1“ ist zugeschnitten: In der SVG-Datei wird er ein Bild</translation>
    </message>
    <message>
        <source>its pattern &quot;%1&quot; turns and stretches with each shape, but is not bent</source>
        <translation>ihr Muster „%1“ dreht und streckt sich mit jeder Form, wird aber nicht verbogen</translation>
    </message>
    <message>
        <source>a picture in it stays one</source>
        <translation>ein Bild darin bleibt ein Bild</translation>
    </message>
    <message>
        <source>its picture &quot;%1&quot; is not in the file: it is left out</source>
        <translation>ihr Bild „%1“ ist nicht in der Datei: Es wird weggelassen</translation>
    </message>
    <message>
        <source>its text along a path is left out</source>
        <translation>ihr Text entlang eines Pfads wird weggelassen</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; is left out</source>
        <translation>ihr &lt;%1&gt; wird weggelassen</translation>
    </message>
    <message>
        <source>HDF5 files need wend-hdf5, which is missing beside the program: it is built where libhdf5-dev is installed</source>
        <translation>HDF5-Dateien brauchen wend-hdf5, das neben dem Programm fehlt: es wird gebaut, wo libhdf5-dev installiert ist</translation>
    </message>
    <message>
        <source>the HDF5 library fails on it: the file may be damaged</source>
        <translation>die HDF5-Bibliothek scheitert daran: die Datei ist vielleicht beschädigt</translation>
    </message>
    <message>
        <source>is no HDF5 file</source>
        <translation>ist keine HDF5-Datei</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both the same triangles there or leave a gap</source>
        <translation>die Körper %1 und %2 berühren sich entlang einer Fläche, deren Dreiecke nicht zueinander passen (bei %3): geben Sie beiden dort dieselben Dreiecke, oder lassen Sie einen Spalt</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along an edge or at a point (near %3): give both the same triangles there or leave a gap</source>
        <translation>die Körper %1 und %2 berühren sich entlang einer Kante oder in einem Punkt (bei %3): geben Sie beiden dort dieselben Dreiecke, oder lassen Sie einen Spalt</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell; it lies at the place of another and moves with it. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 Punkt gehört zu keiner Zelle; er liegt auf einem anderen und bewegt sich mit ihm. Er bleibt in dem, was geschrieben wird: Manche Löser wollen ihn vorher entfernt haben</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell; %2 of them lie at the place of another and move with it. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 Eckpunkte gehören zu keiner Zelle; %2 davon liegen auf einem anderen und bewegen sich mit ihm. Sie bleiben in dem, was geschrieben wird: Manche Löser wollen sie vorher entfernt haben</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more</source>
        <translation>%1: Die Oberfläche bleibt, wie sie ist, und erzwingt es an ihren Dreiecken %2 und %3 weiteren</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; has the blend mode %2: it is shown as normal</source>
        <translation>die Ebene „%1“ hat den Füllmodus %2: Sie wird normal gezeigt</translation>
    </message>
    <message>
        <source>1 hole of %1 edges stayed open, larger than the limit of %2</source>
        <translation>1 Loch mit %1 Kanten blieb offen, größer als die Grenze von %2</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 edges stayed open, larger than the limit of %3</source>
        <translation>%1 Löcher mit bis zu %2 Kanten blieben offen, größer als die Grenze von %3</translation>
    </message>
    <message>
        <source>1 vertex of open seams welded, the widest gap %1</source>
        <translation>1 Eckpunkt offener Nähte verschweißt, der breiteste Spalt %1</translation>
    </message>
    <message>
        <source>%1 vertices of open seams welded, the widest gap %2</source>
        <translation>%1 Eckpunkte offener Nähte verschweißt, der breiteste Spalt %2</translation>
    </message>
    <message>
        <source> (after the repair: %1)</source>
        <translation> (nach der Reparatur: %1)</translation>
    </message>
    <message>
        <source>; the repair found nothing that it could repair</source>
        <translation>; die Reparatur fand nichts, was sie reparieren könnte</translation>
    </message>
    <message>
        <source>%1 and %2 move the joint at %3 in different ways at time %4</source>
        <translation>%1 und %2 bewegen das Gelenk bei %3 zur Zeit %4 verschieden</translation>
    </message>
    <message>
        <source>the multigrid solver did not find the velocities near %1; solve directly (--solver direct), or make the material or the mesh more even</source>
        <translation>der Mehrgitterlöser fand die Geschwindigkeiten bei %1 nicht; direkt lösen (--solver direct) oder Material oder Netz gleichmäßiger machen</translation>
    </message>
    <message>
        <source>%1: its points have any number of coordinates; only points in space, which have three, are read</source>
        <translation>%1: Die Punkte haben beliebig viele Koordinaten; gelesen werden nur Punkte im Raum, die drei haben</translation>
    </message>
    <message>
        <source>%1 vertex that is not finite (first: %2)</source>
        <translation>%1 nicht endlicher Eckpunkt (%2)</translation>
    </message>
    <message>
        <source>%1 vertices that are not finite (first: %2)</source>
        <translation>%1 nicht endliche Eckpunkte (zuerst %2)</translation>
    </message>
    <message>
        <source>%1 triangle that names a missing vertex (first: %2)</source>
        <translation>%1 Dreieck mit einem Eckpunkt, den es nicht gibt (%2)</translation>
    </message>
    <message>
        <source>%1 triangles that name a missing vertex (first: %2)</source>
        <translation>%1 Dreiecke mit einem Eckpunkt, den es nicht gibt (zuerst %2)</translation>
    </message>
    <message>
        <source>an IFF file</source>
        <translation>eine IFF-Datei</translation>
    </message>
    <message>
        <source>a KTX texture</source>
        <translation>eine KTX-Textur</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>ein PostScript-Dokument</translation>
    </message>
    <message>
        <source>a PAM picture</source>
        <translation>ein PAM-Bild</translation>
    </message>
    <message>
        <source>a Windows cursor</source>
        <translation>ein Windows-Mauszeiger</translation>
    </message>
    <message>
        <source>a QOI picture</source>
        <translation>ein QOI-Bild</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 2 GB, these layers have more</source>
        <translation>kann nicht geschrieben werden: Eine Photoshop-Datei hat höchstens 2 GB, diese Ebenen haben mehr</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 30000 pixels a side</source>
        <translation>kann nicht geschrieben werden: Eine Photoshop-Datei hat höchstens 30000 Pixel je Seite</translation>
    </message>
    <message>
        <source>the shape is too stiff to settle further near %1: the steps would be too short; allow a larger tolerance</source>
        <translation>die Form ist bei %1 zu steif, um sich weiter zu setzen: Die Schritte würden zu kurz; eine größere Toleranz hilft</translation>
    </message>
    <message>
        <source>%1 cannot go on: %2</source>
        <translation>%1 kann nicht weiter: %2</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and once more</source>
        <translation>zur Zeit %1 springt die Form nahe %2 in ein anderes Gleichgewicht, und noch einmal</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2</source>
        <translation>bei %1 s springt die Form nahe %2 in eine andere Pose</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and once more</source>
        <translation>bei %1 s springt die Form nahe %2 in eine andere Pose, und noch einmal</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and %3 times more</source>
        <translation>bei %1 s springt die Form nahe %2 in eine andere Pose, und noch %3 Mal</translation>
    </message>
</context>
<context>
    <name>CropTool</name>
    <message>
        <source>Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the proportions, Delete or a double-click removes it</source>
        <translation>Ein Rechteck um das ziehen, was Exporte behalten; sein Inneres oder seine Seiten ziehen; Umschalt hält die Proportionen, Entf oder ein Doppelklick nimmt es weg</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Change curve</source>
        <translation>Kurve ändern</translation>
    </message>
    <message>
        <source>Double-click to insert a point into the curve</source>
        <translation>Ein Doppelklick fügt einen Punkt in die Kurve ein</translation>
    </message>
    <message>
        <source>Insert curve point</source>
        <translation>Kurvenpunkt einfügen</translation>
    </message>
    <message>
        <source>Delete curve point</source>
        <translation>Kurvenpunkt löschen</translation>
    </message>
    <message>
        <source>The ends of a curve must stay.</source>
        <translation>Die Enden einer Kurve müssen bleiben.</translation>
    </message>
    <message>
        <source>Drag the curve&apos;s point, Shift keeps it straight, Ctrl moves one direction only; Delete removes it, a right-click shows more</source>
        <translation>Den Punkt der Kurve ziehen, mit Umschalt gerade, mit Strg nur eine Richtung; Entf löscht ihn, ein Rechtsklick zeigt mehr</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Drag the arrow to move the cut, the rings to tilt it; Esc puts it back</source>
        <translation>Der Pfeil verschiebt den Schnitt, die Ringe kippen ihn; Esc stellt ihn zurück</translation>
    </message>
</context>
<context>
    <name>DepthTool</name>
    <message>
        <source>Brush over what lies in front or behind; Ctrl clears it, Shift swaps front and back, [ and ] change the size</source>
        <translation>Überstreichen, was vorn oder hinten liegt; Strg nimmt es zurück, Umschalt kehrt es um, [ und ] ändern die Größe</translation>
    </message>
    <message>
        <source>Paint in front</source>
        <translation>Nach vorn malen</translation>
    </message>
    <message>
        <source>Paint behind</source>
        <translation>Nach hinten malen</translation>
    </message>
    <message>
        <source>Clear depth</source>
        <translation>Tiefe zurücknehmen</translation>
    </message>
</context>
<context>
    <name>EaseNames</name>
    <message>
        <source>Ease &amp;In</source>
        <translation>Ease-&amp;In</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>Ease-&amp;Out</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Ease-In u&amp;nd -Out</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
</context>
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Starr</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Nothing grows or shrinks. Parts may get thin.</source>
        <translation>Nichts wächst oder schrumpft. Teile können dünn werden.</translation>
    </message>
    <message>
        <source>Stretches least. Start here.</source>
        <translation>Dehnt am wenigsten. Gut für den Anfang.</translation>
    </message>
    <message>
        <source>Parts turn like card.</source>
        <translation>Teile drehen sich wie Pappe.</translation>
    </message>
    <message>
        <source>Details keep their look. Parts may swell.</source>
        <translation>Einzelheiten behalten ihr Aussehen. Teile können anschwellen.</translation>
    </message>
</context>
<context>
    <name>ExportFormats</name>
    <message>
        <source>Layers (OpenRaster)</source>
        <translation>Ebenen (OpenRaster)</translation>
    </message>
    <message>
        <source>This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). Animated WebP needs no other program.</source>
        <translation>Diesen Film macht das Programm ffmpeg, das nicht installiert ist (Debian: sudo apt install ffmpeg). Animiertes WebP braucht kein anderes Programm.</translation>
    </message>
    <message>
        <source>glTF film</source>
        <translation>glTF-Film</translation>
    </message>
    <message>
        <source>Spine skeleton</source>
        <translation>Spine-Skelett</translation>
    </message>
    <message>
        <source>DragonBones skeleton</source>
        <translation>DragonBones-Skelett</translation>
    </message>
    <message>
        <source>Layers (Photoshop)</source>
        <translation>Ebenen (Photoshop)</translation>
    </message>
</context>
<context>
    <name>FileCard</name>
    <message>
        <source>Eyes stay round</source>
        <translation>Runde Augen</translation>
    </message>
    <message>
        <source>Pins and paths</source>
        <translation>Pins und Wege</translation>
    </message>
    <message>
        <source>Many pins at once</source>
        <translation>Viele Pins</translation>
    </message>
    <message>
        <source>Flight, with a skin</source>
        <translation>Flug mit Haut</translation>
    </message>
    <message>
        <source>A stiff middle</source>
        <translation>Steife Mitte</translation>
    </message>
    <message>
        <source>Frog</source>
        <translation>Frosch</translation>
    </message>
    <message>
        <source>Giraffe</source>
        <translation>Giraffe</translation>
    </message>
    <message>
        <source>Octopus</source>
        <translation>Krake</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Eagle</source>
        <translation>Adler</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Balken</translation>
    </message>
    <message>
        <source>Choose what to keep</source>
        <translation>Wählen, was bleibt</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Wanderer</translation>
    </message>
    <message>
        <source>A walk that loops</source>
        <translation>Gehen in Schleife</translation>
    </message>
</context>
<context>
    <name>FillTool</name>
    <message>
        <source>Click to pick up what is painted there</source>
        <translation>Klicken, um aufzunehmen, was dort gemalt ist</translation>
    </message>
    <message>
        <source>Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up</source>
        <translation>Klicken füllt, was dort zusammenhängt; Umschalt füllt alles, Strg nimmt Farbe weg, Alt nimmt auf</translation>
    </message>
    <message>
        <source>Fill with %1</source>
        <translation>Mit %1 füllen</translation>
    </message>
</context>
<context>
    <name>GrabTool</name>
    <message>
        <source>Draw around the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Um den Teil zeichnen, der gehalten werden soll; Umschalt fügt zum gewählten Teil hinzu, Strg nimmt weg</translation>
    </message>
    <message>
        <source>Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Über den Teil streichen, der gehalten werden soll; [ und ] ändern die Größe; Umschalt fügt hinzu, Strg nimmt weg</translation>
    </message>
    <message>
        <source>Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Ein Rechteck über den Teil ziehen, der gehalten werden soll; Umschalt fügt zum gewählten Teil hinzu, Strg nimmt weg</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>No part of the shape lies in this outline.</source>
        <translation>In diesem Umriss liegt nichts von der Form.</translation>
    </message>
    <message>
        <source>Select one part to take away from.</source>
        <translation>Einen Teil auswählen, von dem etwas weggenommen werden soll.</translation>
    </message>
    <message>
        <source>A handle must hold something; Delete removes it.</source>
        <translation>Ein Griff kann nicht nichts halten: Entf entfernt ihn.</translation>
    </message>
</context>
<context>
    <name>GradientTool</name>
    <message>
        <source>Move gradient</source>
        <translation>Verlauf verschieben</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Zu %1</translation>
    </message>
    <message>
        <source>Blend to %1</source>
        <translation>In %1 übergehen lassen</translation>
    </message>
    <message>
        <source>Drag over the shape to blend evenly from what is there to what is chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels</source>
        <translation>Über die Form ziehen: was dort ist, geht gleichmäßig in das über, was rechts gewählt ist; Umschalt in Schritten von 45°, Alt nimmt auf, Esc bricht ab</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>angle error %1</source>
        <translation>Winkelfehler %1</translation>
    </message>
    <message>
        <source>volume ×%1</source>
        <translation>Volumen ×%1</translation>
    </message>
    <message>
        <source>area ×%1</source>
        <translation>Fläche ×%1</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>stretch %1</source>
        <translation>Dehnung %1</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scherung</translation>
    </message>
    <message>
        <source>Distance from rest</source>
        <translation>Weg seit der Ruhe</translation>
    </message>
    <message>
        <source>Influence of the pin</source>
        <translation>Einfluss des Pins</translation>
    </message>
    <message>
        <source>Stretched too far here · %1</source>
        <translation>Hier zu weit gedehnt · %1</translation>
    </message>
    <message>
        <source>Grown too far here · %1</source>
        <translation>Hier zu weit gewachsen · %1</translation>
    </message>
    <message>
        <source>Shrunk too far here · %1</source>
        <translation>Hier zu weit geschrumpft · %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Jacobi (skaliert)</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Min. Diederwinkel</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>angle %1, at rest %2</source>
        <translation>Winkel %1, in Ruhe %2</translation>
    </message>
    <message>
        <source>length %1, at rest %2</source>
        <translation>Länge %1, in Ruhe %2</translation>
    </message>
    <message>
        <source>Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears</source>
        <translation>Zwei Punkte messen eine Länge, ein dritter den Winkel; Strg nimmt Netzpunkte, Esc löscht</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>number of frames, evenly spaced from the start to the last time</source>
        <translation>Zahl der Bilder, zu gleichen Abständen vom Anfang bis zur letzten Zeit</translation>
    </message>
    <message>
        <source>whether distortion, φ, directions and velocity are written with meshes, in formats that carry values</source>
        <translation>ob Verzerrung, φ, Richtungen und Geschwindigkeit mit Netzen gehen, in Formaten, die Werte tragen</translation>
    </message>
    <message>
        <source>how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)</source>
        <translation>wie Zahlen in Netzdateien stehen, die mehrere Arten kennen (ply, stl, msh, vtk, vtu)</translation>
    </message>
    <message>
        <source>version of .msh files</source>
        <translation>Version von .msh-Dateien</translation>
    </message>
    <message>
        <source>write the triangles of a solid&apos;s border as cells too, with the values of the tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless the input had such triangles</source>
        <translation>auch die Dreiecke am Rand eines Körpers als Zellen schreiben, mit den Werten der Tetraeder dahinter; ohne das haben .vtu und .vtk nur Tetraeder, außer wenn die Eingabe solche Dreiecke hatte</translation>
    </message>
    <message>
        <source>how the picture is sampled</source>
        <translation>wie das Bild abgetastet wird</translation>
    </message>
    <message>
        <source>bits per channel in pictures: as in the source, 8 or 16, or half or full floating point; values stay what they are</source>
        <translation>Bits eines Kanals in Bildern: wie im Original, 8 oder 16, oder eine halbe oder ganze Gleitkommazahl; Werte bleiben, was sie sind</translation>
    </message>
    <message>
        <source>what pictures show around the shape: nothing, its border drawn outwards, the source as it was, or a colour</source>
        <translation>was Bilder neben der Form zeigen: nichts, ihren fortgesetzten Rand, das Original, wie es war, oder eine Farbe</translation>
    </message>
    <message>
        <source>Det&amp;ail, in vertices</source>
        <translation>Fein&amp;heit, in Punkten</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation>Wie fein das Netz ist. Mehr Punkte biegen sich glatter und brauchen länger.</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>Feinheit ändern</translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation>&amp;Umriss</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>Umriss ändern</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation>Gezeichnete Polygone</translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation>Pixel, die stärker decken, gehören zur Form.</translation>
    </message>
    <message>
        <source>Change what counts as solid</source>
        <translation>Ändern, was als deckend gilt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>The outline grows by this much, so that soft edges are kept whole.</source>
        <translation>Um so viel wird der Umriss erweitert, damit weiche Kanten ganz mitkommen.</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>Rand ändern</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Bildrand</translation>
    </message>
    <message>
        <source>Picture&apos;s border</source>
        <translation>Bildrand</translation>
    </message>
    <message>
        <source>Holds the frame of a photograph, so that no gap opens at its edge: it stays where it is, or its sides slide along themselves. Pins on it still move.</source>
        <translation>Hält den Rand eines Fotos fest, damit daneben keine Lücke entsteht: Er bleibt, wo er ist, oder seine Seiten gleiten an sich entlang. Pins auf ihm bewegen sich trotzdem.</translation>
    </message>
    <message>
        <source>Hold the border</source>
        <translation>Bildrand festhalten</translation>
    </message>
    <message>
        <source>Moves freely</source>
        <translation>Bewegt sich frei</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Bleibt am Ort</translation>
    </message>
    <message>
        <source>Slides along itself</source>
        <translation>Gleitet an sich entlang</translation>
    </message>
    <message>
        <source>Radius–edge rati&amp;o</source>
        <translation>Radius zu Kan&amp;te</translation>
    </message>
    <message>
        <source>How flat the tetrahedra may be: the maximum ratio of circumradius to shortest edge. Smaller is rounder and takes more of them.</source>
        <translation>Wie flach die Tetraeder sein dürfen: das größte Verhältnis von Umkreisradius zu kürzester Kante. Kleiner ist runder und braucht mehr davon.</translation>
    </message>
    <message>
        <source>Change radius–edge ratio</source>
        <translation>Radius zu Kante ändern</translation>
    </message>
    <message>
        <source>Ma&amp;ximum volume</source>
        <translation>&amp;Größtes Volumen</translation>
    </message>
    <message>
        <source>Larger tetrahedra are split; in the file&apos;s units, cubed. Half the volume makes about twice as many. At a surface that is kept, some may stay larger.</source>
        <translation>Größere Tetraeder werden geteilt; in Einheiten der Datei hoch drei. Die Hälfte ergibt etwa doppelt so viele. An einer Oberfläche, die bleibt, können einige größer bleiben.</translation>
    </message>
    <message>
        <source>Change maximum volume</source>
        <translation>Größtes Volumen ändern</translation>
    </message>
    <message>
        <source>Refine s&amp;urface</source>
        <translation>Oberfläche ver&amp;feinern</translation>
    </message>
    <message>
        <source>Allows the surface&apos;s triangles to be split where they are larger than the tetrahedra inside. If off, the surface is kept exactly as it is.</source>
        <translation>Lässt Dreiecke der Oberfläche teilen, wo sie größer sind als die Tetraeder im Innern. Aus: die Oberfläche bleibt genau, wie sie ist.</translation>
    </message>
    <message>
        <source>Refine surface</source>
        <translation>Oberfläche verfeinern</translation>
    </message>
    <message>
        <source>Fill holes up to (edges)</source>
        <translation>Löcher füllen bis (Kanten)</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>Größtes Loch</translation>
    </message>
    <message>
        <source>“Repair” fills holes of at most this many edges.</source>
        <translation>„Reparieren“ füllt Löcher von höchstens so vielen Kanten.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>&amp;Füllung</translation>
    </message>
    <message>
        <source>What is filled: the surface itself, or a cage of even cells around it, in which it is embedded. Automatic takes the cage where the surface cannot be filled or has far too many vertices.</source>
        <translation>Was gefüllt wird: die Oberfläche selbst oder ein Käfig gleichmäßiger Zellen um sie herum, in dem sie mitfährt. Automatisch nimmt den Käfig, wo sich die Oberfläche nicht füllen lässt oder viel zu viele Punkte hat.</translation>
    </message>
    <message>
        <source>Change fit</source>
        <translation>Füllung ändern</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Exact surface</source>
        <translation>Genaue Oberfläche</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Exact &amp;balance</source>
        <translation>&amp;Genaues Verhältnis</translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation>Energie ändern</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
    <message>
        <source>Smoothi&amp;ng length</source>
        <translation>Glättungslän&amp;ge</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads, as a fraction of the shape&apos;s size. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation>Wie weit der Zug eines Pins verteilt wird, als Teil der Größe der Form. Klein: nah am Pin, scharf. Groß: weich und weit.</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Glättung ändern</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>&amp;Bilder</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Werte</translation>
    </message>
    <message>
        <source>Errors, material, velocity</source>
        <translation>Fehler, Material, Geschwindigkeit</translation>
    </message>
    <message>
        <source>The shape alone</source>
        <translation>Nur die Form</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Zahlen</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Als Text</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binär</translation>
    </message>
    <message>
        <source>Binary, compressed</source>
        <translation>Binär, gepackt</translation>
    </message>
    <message>
        <source>&amp;Gmsh version</source>
        <translation>&amp;Gmsh-Version</translation>
    </message>
    <message>
        <source>&amp;Border triangles</source>
        <translation>&amp;Dreiecke des Randes</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>&amp;Filter</translation>
    </message>
    <message>
        <source>Nearest – hard pixels</source>
        <translation>Nächster – harte Pixel</translation>
    </message>
    <message>
        <source>Bilinear – quick</source>
        <translation>Bilinear – schnell</translation>
    </message>
    <message>
        <source>Bicubic – sharp</source>
        <translation>Bikubisch – scharf</translation>
    </message>
    <message>
        <source>EWA – best</source>
        <translation>EWA – am besten</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Leinwand</translation>
    </message>
    <message>
        <source>As large as the picture</source>
        <translation>So groß wie das Bild</translation>
    </message>
    <message>
        <source>Fit to the shape</source>
        <translation>An die Form angepasst</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Wie im Bild</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>16 bit floating point (half)</source>
        <translation>16 Bit Gleitkomma (half)</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>The border, drawn outwards</source>
        <translation>Der fortgesetzte Rand</translation>
    </message>
    <message>
        <source>The picture as it was</source>
        <translation>Das Bild, wie es war</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>How far apart growing the outline keeps parts and limbs, so that they do not become one.</source>
        <translation>So weit hält das Vergrößern Teile und Glieder auseinander, damit sie nicht eins werden.</translation>
    </message>
    <message>
        <source>Change gap</source>
        <translation>Lücke ändern</translation>
    </message>
    <message>
        <source>Parts and holes of fewer pixels, such as dust around a drawing, are left out.</source>
        <translation>Teile und Löcher aus weniger Pixeln, etwa Staub um eine Zeichnung, werden weggelassen.</translation>
    </message>
    <message>
        <source>Change what is left out</source>
        <translation>Ändern, was weggelassen wird</translation>
    </message>
    <message>
        <source>&amp;Gap</source>
        <translation>&amp;Lücke</translation>
    </message>
    <message>
        <source>Drop &amp;below</source>
        <translation>&amp;Weglassen unter</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>Obere Achse ändern</translation>
    </message>
    <message>
        <source>pixels that pictures show: those of the source, as many as the shape needs, or those of a rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it</source>
        <translation>welche Pixel Bilder zeigen: die der Vorlage, so viele wie die Form braucht, oder die eines Rechtecks X,Y,BREITE,HÖHE der Vorlage, das über sie hinausreichen darf</translation>
    </message>
    <message>
        <source>Another colour …</source>
        <translation>Andere Farbe …</translation>
    </message>
    <message>
        <source>R&amp;ate</source>
        <translation>Bild&amp;rate</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>whether WebP pictures and films keep every pixel, or are a fraction of the size with hardly visible losses</source>
        <translation>ob WebP-Bilder und -Filme jedes Pixel behalten oder mit kaum sichtbaren Verlusten nur einen Bruchteil so groß sind</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Every pixel – lossless</source>
        <translation>Jedes Pixel – verlustfrei</translation>
    </message>
    <message>
        <source>Smaller file – lossy</source>
        <translation>Kleinere Datei – mit Verlusten</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Federt zurück</translation>
    </message>
    <message>
        <source>Lead a pin around and back: how far does the shape come back, too? Not at all: where it ends depends on the path. Fully: it is as it was.</source>
        <translation>Ein Pin geht herum und wieder zurück: Wie weit kommt auch die Form zurück? Gar nicht: Wo sie endet, hängt vom Weg ab. Ganz: Sie ist, wie sie war.</translation>
    </message>
    <message>
        <source>Change springing back</source>
        <translation>Zurückfedern ändern</translation>
    </message>
    <message>
        <source>Opa&amp;que from</source>
        <translation>&amp;Deckend ab</translation>
    </message>
    <message>
        <source>Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid).</source>
        <translation>Erhalt als Zahl φ, wie in der Projektdatei: 0,002 erhält Fläche oder Volumen, 0,464 Länge, 1,571 ist starr, 2,678 erhält Winkel (2,498 in einem Körper).</translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, this with what its lines enclose, or the picture as a whole.</source>
        <translation>Was sich biegt: nur, was im Bild deckt, dies samt dem, was seine Linien umschließen, oder das Bild als Ganzes.</translation>
    </message>
    <message>
        <source>Cut-out, holes filled</source>
        <translation>Ausschnitt, Löcher gefüllt</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Löser ändern</translation>
    </message>
    <message>
        <source>frames per second of a film; a unit of time is a second</source>
        <translation>Bilder pro Sekunde eines Films; eine Zeiteinheit ist eine Sekunde</translation>
    </message>
    <message>
        <source>Change frame rate</source>
        <translation>Bildrate ändern</translation>
    </message>
    <message>
        <source>leave the last frame out, which is the first one again: for films that repeat; if the project has a cycle, show that</source>
        <translation>das letzte Bild weglassen, das wieder das erste ist: für Filme, die sich wiederholen; hat das Projekt einen Zyklus, ihn zeigen</translation>
    </message>
    <message>
        <source>Loop: no fra&amp;me twice</source>
        <translation>Schleife: kein Bild d&amp;oppelt</translation>
    </message>
    <message>
        <source>size of pictures in percent of the canvas; that of frames becomes even</source>
        <translation>Größe der Bilder in Prozent der Leinwand; die von Filmbildern wird gerade</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>width of pictures, instead of a size in percent</source>
        <translation>Breite der Bilder, statt einer Größe in Prozent</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Inner she&amp;lls</source>
        <translation>&amp;Innere Schalen</translation>
    </message>
    <message>
        <source>What is inside of shells that lie one in the other: holes, or regions of their own, whose cells are labelled. Bodies that share walls are all filled and labelled.</source>
        <translation>Was innerhalb von Schalen ist, die ineinander liegen: Löcher oder eigene Bereiche, deren Zellen Marken haben. Körper mit gemeinsamen Wänden werden alle gefüllt und markiert.</translation>
    </message>
    <message>
        <source>Change inner shells</source>
        <translation>Innere Schalen ändern</translation>
    </message>
    <message>
        <source>Holes, and say so</source>
        <translation>Löcher, mit Hinweis</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Bereiche</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>Draw around what should bend, too; Ctrl takes it away, Esc cancels</source>
        <translation>Umfahren, was sich mit biegen soll; mit Strg wird es weggenommen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Brush over what should bend, too; Ctrl takes it away, [ and ] change the size</source>
        <translation>Überstreichen, was sich mit biegen soll, [ und ] ändern die Größe; Strg nimmt weg</translation>
    </message>
    <message>
        <source>Click a colour that should bend, too; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Auf eine Farbe klicken, die sich mit biegen soll; Strg nimmt sie weg, [ und ] nehmen weniger oder mehr Farben</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape; Esc cancels</source>
        <translation>Eine Linie zeichnen, an der die Form getrennt wird; Esc bricht ab</translation>
    </message>
    <message>
        <source>Nothing would be left of the shape.</source>
        <translation>Von der Form bliebe nichts übrig.</translation>
    </message>
    <message numerus="yes">
        <source>Pins outside the new outline were removed: %n.</source>
        <translation>
            <numerusform>%n Pin lag neben dem neuen Umriss und wurde entfernt.</numerusform>
            <numerusform>%n Pins lagen neben dem neuen Umriss und wurden entfernt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Zerschneiden</translation>
    </message>
    <message>
        <source>Take away from the outline</source>
        <translation>Vom Umriss wegnehmen</translation>
    </message>
    <message>
        <source>Add to the outline</source>
        <translation>Zum Umriss hinzufügen</translation>
    </message>
    <message>
        <source>The tolerance, or [ and ], changes what was taken; click another colour to take it too, with Ctrl to take it away</source>
        <translation>Die Toleranz, auch [ und ], ändert, was genommen wurde; ein Klick auf eine andere Farbe nimmt sie dazu, mit Strg weg</translation>
    </message>
    <message>
        <source>That was a line. Draw around a part of the picture.</source>
        <translation>Das war eine Linie. Umfahren Sie einen Teil des Bildes.</translation>
    </message>
    <message>
        <source>From now on the outline is as you draw it, and has no margin to change. Choose “Cut-out” as the outline to go back to the one that was found.</source>
        <translation>Der Umriss ist von nun an, wie Sie ihn zeichnen, und hat keinen Rand mehr. „Ausschnitt“ als Umriss bringt den gefundenen zurück.</translation>
    </message>
    <message>
        <source>Draw around what should bend; Ctrl takes it away, Esc cancels</source>
        <translation>Umfahren, was sich biegen soll; mit Strg wird es weggenommen. Esc bricht ab</translation>
    </message>
    <message>
        <source>Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl takes away, Backspace removes the last corner, Esc cancels</source>
        <translation>Ecke für Ecke klicken, Umschalt in Schritten von 45°, ein Doppelklick schließt; Strg nimmt weg, die Rücktaste nimmt eine Ecke zurück, Esc bricht ab</translation>
    </message>
    <message>
        <source>Brush over what should bend; Ctrl takes it away, [ and ] change the size</source>
        <translation>Überstreichen, was sich biegen soll, [ und ] ändern die Größe; Strg nimmt weg</translation>
    </message>
    <message>
        <source>Click a colour that should bend; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Auf eine Farbe klicken, die sich biegen soll; Strg nimmt sie weg, [ und ] nehmen weniger oder mehr Farben</translation>
    </message>
    <message>
        <source>Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels</source>
        <translation>Umfahren, was ein eigenes Teil wird, bis dahin, wo es am Rest hängt; Esc bricht ab</translation>
    </message>
    <message>
        <source>This picture has parts: choose the one in the list that this outline is for, or Make a Part to cut another one out.</source>
        <translation>Dieses Bild hat Teile: Wählen Sie in der Liste den, für den dieser Umriss ist, oder „Teil machen“, um noch einen auszuschneiden.</translation>
    </message>
    <message>
        <source>“%1” is locked. The list of parts unlocks it.</source>
        <translation>„%1“ ist gesperrt. Die Liste der Teile entsperrt ihn.</translation>
    </message>
</context>
<context>
    <name>PaintTool</name>
    <message>
        <source>There is no direction to follow: the numbers on the right were used.</source>
        <translation>Es gibt keine Richtung, der zu folgen wäre: die Zahlen rechts wurden genommen.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Steif</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Versteift</translation>
    </message>
    <message>
        <source>Combed</source>
        <translation>Gekämmt</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Erase paint from %1</source>
        <translation>Farbe von %1 nehmen</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 glätten</translation>
    </message>
    <message>
        <source>Comb %1</source>
        <translation>%1 kämmen</translation>
    </message>
    <message>
        <source>Paint %1 on %2</source>
        <translation>%1 auf %2 malen</translation>
    </message>
    <message>
        <source>Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Entlang der Richtung kämmen, in der es steif sein soll; Strg nimmt weg, Umschalt glättet, Klick mit Umschalt zieht eine Linie, Alt-Klick nimmt auf, Esc gibt den Strich auf</translation>
    </message>
    <message>
        <source>Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Malen, was rechts gewählt ist; Strg nimmt weg, Umschalt glättet, Klick mit Umschalt zieht eine Linie, Alt-Klick nimmt auf, Esc gibt den Strich auf</translation>
    </message>
    <message>
        <source>Stiffness ×1 is the same as everywhere and changes nothing: choose on the right how many times stiffer it should be</source>
        <translation>Steifigkeit ×1 ist wie überall und ändert hier nichts: rechts wählen, wievielmal steifer es sein soll</translation>
    </message>
    <message>
        <source>Erase paint</source>
        <translation>Farbe wegnehmen</translation>
    </message>
    <message>
        <source>Erases paint from all visible layers: brush over what should be like the rest again; Shift-click draws a line, Esc cancels the stroke</source>
        <translation>Nimmt Farbe von allen sichtbaren Ebenen: überstreichen, was wieder wie überall sein soll; Klick mit Umschalt zieht eine Linie, Esc gibt den Strich auf</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Kämmen</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>%1 malen</translation>
    </message>
    <message>
        <source>Nothing is painted there</source>
        <translation>Dort ist nichts gemalt</translation>
    </message>
</context>
<context>
    <name>PanTool</name>
    <message>
        <source>Drag to move the view; the wheel zooms</source>
        <translation>Ziehen verschiebt die Ansicht; das Rad zoomt</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>There is nothing of the picture in this area.</source>
        <translation>In diesem Bereich ist nichts vom Bild.</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>Teil machen</translation>
    </message>
    <message>
        <source>“%1” is a part now, joined to “%2” where it hangs on it. What is behind it is being filled.</source>
        <translation>„%1“ ist nun ein Teil, mit „%2“ verbunden, wo es daran hängt. Was dahinter liegt, wird gefüllt.</translation>
    </message>
    <message>
        <source>“%1” is a part now, cut from “%2”. What is behind it is being filled. Pin it, or join it under Parts.</source>
        <translation>„%1“ ist nun ein Teil, aus „%2“ ausgeschnitten. Was dahinter liegt, wird gefüllt. Heften Sie es an, oder verbinden Sie es unter Teile.</translation>
    </message>
    <message>
        <source>In this area is nothing but what is locked, if anything. The list of parts unlocks it.</source>
        <translation>In diesem Bereich ist höchstens Gesperrtes. Die Liste der Teile entsperrt es.</translation>
    </message>
    <message>
        <source>The parts are still being made. Another one can be made as soon as they are there.</source>
        <translation>Die Teile werden noch gemacht. Sobald sie da sind, lässt sich ein weiterer machen.</translation>
    </message>
</context>
<context>
    <name>PenTool</name>
    <message>
        <source>Click the pin whose path you want to draw</source>
        <translation>Auf den Pin klicken, dessen Weg gezeichnet werden soll</translation>
    </message>
    <message>
        <source>Click where the selected pin should go, point by point; drag for a smooth point</source>
        <translation>Punkt für Punkt dorthin klicken, wohin der gewählte Pin gehen soll; Ziehen setzt einen glatten Punkt</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, Shift snaps to 45°; Enter ends, Backspace removes the last point, Esc cancels</source>
        <translation>Klicken für eine Ecke, ziehen für einen glatten Punkt, Umschalt in Schritten von 45°; Enter beendet, Rücktaste nimmt einen Punkt zurück, Esc bricht ab</translation>
    </message>
    <message>
        <source>Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only</source>
        <translation>Ziehen macht einen glatten Punkt: Umschalt rastet auf 45° ein, mit Strg oder Alt bewegt sich nur diese Seite</translation>
    </message>
</context>
<context>
    <name>PictureTip</name>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
    <message>
        <source>far</source>
        <translation>weit</translation>
    </message>
    <message>
        <source>×1 everywhere</source>
        <translation>überall ×1</translation>
    </message>
    <message>
        <source>×50 along the left half</source>
        <translation>×50 entlang der linken Hälfte</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>gar nicht</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>ganz</translation>
    </message>
    <message>
        <source>as it was pulled</source>
        <translation>wie gezogen</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>entspannt</translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag as far as the pin should hold; Esc cancels</source>
        <translation>So weit ziehen, wie der Pin halten soll; Esc gibt es auf</translation>
    </message>
    <message>
        <source>Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number</source>
        <translation>Den Punkt ziehen dreht, mit Umschalt um je 15°, das Quadrat skaliert; Ziffern setzen die Zahl</translation>
    </message>
    <message>
        <source>%1: holds from %2 s</source>
        <translation>%1: hält ab %2 s</translation>
    </message>
    <message>
        <source>%1: released at %2 s</source>
        <translation>%1: losgelassen bei %2 s</translation>
    </message>
    <message>
        <source>Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl records it; digits set the number</source>
        <translation>Irgendwo ziehen dreht, was gewählt ist, mit Umschalt um je 15°, mit Strg wird es aufgenommen; Ziffern setzen die Zahl</translation>
    </message>
    <message>
        <source>Drag anywhere to scale what is selected, Ctrl records it; digits set the number</source>
        <translation>Irgendwo ziehen skaliert, was gewählt ist, mit Strg wird es aufgenommen; Ziffern setzen die Zahl</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; G moves, R rotates, S scales</source>
        <translation>Pfeil, Quadrat oder Ring ziehen; G bewegt, R dreht, S skaliert</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, draw around pins to select them</source>
        <translation>Klick auf die Form setzt einen Pin, Ziehen biegt sie sofort; daneben Pins umfahren wählt sie aus</translation>
    </message>
    <message>
        <source>Draw around pins to select them; Shift adds, Ctrl takes away</source>
        <translation>Pins umfahren wählt sie aus; Umschalt dazu, Strg ab</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, brush over pins, [ and ] change the size</source>
        <translation>Klick auf die Form setzt einen Pin, Ziehen biegt sie sofort; daneben über Pins pinseln, [ und ] ändern die Größe</translation>
    </message>
    <message>
        <source>Brush over pins to select them, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Über Pins pinseln wählt sie aus, [ und ] ändern die Größe; Umschalt dazu, Strg ab</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, or press and drag to bend it at once</source>
        <translation>Klick auf die Form setzt einen Pin; drücken und ziehen biegt sie sofort</translation>
    </message>
    <message>
        <source>Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move</source>
        <translation>Klicken oder neben Pins aufziehen wählt aus; Umschalt dazu, Strg ab; Ziehen oder Pfeiltasten bewegen</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y, Z lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Umschalt hält die Richtung gerade; X, Y, Z halten eine Achse fest, Ziffern geben den Betrag, Esc stellt die Form zurück</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Umschalt hält die Richtung gerade; X, Y halten eine Achse fest, Ziffern geben den Betrag, Esc stellt die Form zurück</translation>
    </message>
    <message>
        <source>Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, Shift-click to select more</source>
        <translation>Ziehen bewegt den Pin, mit Strg wird es aufgenommen, mit Strg+Umschalt wird er weiter; Umschalt-Klick wählt weitere</translation>
    </message>
    <message>
        <source>Drag to scale: the point becomes a small circle</source>
        <translation>Ziehen skaliert: Der Punkt wird ein kleiner Kreis</translation>
    </message>
    <message>
        <source>Drag to rotate: the point becomes a small circle, which holds its angle</source>
        <translation>Ziehen dreht: Der Punkt wird ein kleiner Kreis, der seinen Winkel hält</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>Choose one in the list first.</source>
        <translation>Zuerst einen Eintrag der Liste wählen.</translation>
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
        <translation>Wird aufgenommen, wie es geschieht, bis Sie loslassen; Esc gibt es auf</translation>
    </message>
</context>
<context>
    <name>RegionTool</name>
    <message>
        <source>Drag from a point on the surface to hold a ball; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Von einem Punkt der Oberfläche ziehen hält eine Kugel; Umschalt nimmt ihren Inhalt zum gewählten Griff dazu, Strg nimmt ihn weg</translation>
    </message>
    <message>
        <source>Drag from a point on the surface towards the side to hold: all that lies beyond the point</source>
        <translation>Von einem Punkt der Oberfläche in die Richtung ziehen, die gehalten wird: alles jenseits des Punkts</translation>
    </message>
    <message>
        <source>Drag from a point on the surface to hold a box; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Von einem Punkt der Oberfläche ziehen hält einen Quader; Umschalt nimmt seinen Inhalt zum gewählten Griff dazu, Strg nimmt ihn weg</translation>
    </message>
    <message>
        <source>There is no vertex in this region.</source>
        <translation>In diesem Gebiet liegt kein Punkt.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
</context>
<context>
    <name>SampleNames</name>
    <message>
        <source>back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Gesicht</translation>
    </message>
    <message>
        <source>far front hoof</source>
        <translation>abgewandter Vorderhuf</translation>
    </message>
    <message>
        <source>far hind hoof</source>
        <translation>abgewandter Hinterhuf</translation>
    </message>
    <message>
        <source>front hoof</source>
        <translation>Vorderhuf</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>hind hoof</source>
        <translation>Hinterhuf</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>linker Ellbogen</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>linkes Ende</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>linkes Auge</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>linker unterer Arm</translation>
    </message>
    <message>
        <source>left middle arm</source>
        <translation>linker mittlerer Arm</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>linker oberer Arm</translation>
    </message>
    <message>
        <source>left wing</source>
        <translation>linker Flügel</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>rechtes Ende</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>rechtes Auge</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>rechter unterer Arm</translation>
    </message>
    <message>
        <source>right middle arm</source>
        <translation>rechter mittlerer Arm</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>rechter oberer Arm</translation>
    </message>
    <message>
        <source>right wing</source>
        <translation>rechter Flügel</translation>
    </message>
    <message>
        <source>rump</source>
        <translation>Hinterteil</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>steif</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>far hand</source>
        <translation>abgewandte Hand</translation>
    </message>
    <message>
        <source>far heel</source>
        <translation>abgewandte Ferse</translation>
    </message>
    <message>
        <source>far toe</source>
        <translation>abgewandte Zehe</translation>
    </message>
    <message>
        <source>near hand</source>
        <translation>nahe Hand</translation>
    </message>
    <message>
        <source>near heel</source>
        <translation>nahe Ferse</translation>
    </message>
    <message>
        <source>near toe</source>
        <translation>nahe Zehe</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>Schatten</translation>
    </message>
</context>
<context>
    <name>SizeTool</name>
    <message>
        <source>Brush over what should be meshed finer; Shift makes it coarser, Ctrl evens it out again, [ and ] change the size</source>
        <translation>Überstreichen, was feiner vernetzt werden soll; Umschalt macht es gröber, Strg wieder gleichmäßig, [ und ] ändern die Größe</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Das Netz kommt aus einer Datei und wird verwendet, wie es ist.</translation>
    </message>
    <message>
        <source>Paint finer mesh</source>
        <translation>Netz feiner malen</translation>
    </message>
    <message>
        <source>Paint coarser mesh</source>
        <translation>Netz gröber malen</translation>
    </message>
    <message>
        <source>Paint even mesh</source>
        <translation>Netz gleichmäßig malen</translation>
    </message>
</context>
<context>
    <name>StiffnessFields</name>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
</context>
<context>
    <name>StrokeTool</name>
    <message>
        <source>To the right: larger; up: harder. Esc leaves it as it was</source>
        <translation>Nach rechts: größer; nach oben: härter. Esc lässt ihn, wie er war</translation>
    </message>
    <message>
        <source>%1 px · %2 % hard</source>
        <translation>%1 px · %2 % hart</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Pin</translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation>Pins setzen und ziehen</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation>Pins auswählen und ziehen, ohne neue zu setzen</translation>
    </message>
    <message>
        <source>Grab by &amp;Lasso</source>
        <translation>Mit &amp;Lasso fassen</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a drawn outline as one handle</source>
        <translation>Alles in einem gezeichneten Umriss als einen Griff nehmen</translation>
    </message>
    <message>
        <source>Grab by Bo&amp;x</source>
        <translation>Mit &amp;Rahmen fassen</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a rectangle as one handle</source>
        <translation>Alles in einem Rechteck als einen Griff nehmen</translation>
    </message>
    <message>
        <source>Grab by &amp;Brush</source>
        <translation>Mit &amp;Pinsel fassen</translation>
    </message>
    <message>
        <source>Take hold of what is brushed over as one handle</source>
        <translation>Was überstrichen wird, als einen Griff nehmen</translation>
    </message>
    <message>
        <source>Grab a B&amp;all</source>
        <translation>&amp;Kugel fassen</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a ball around a point on the surface</source>
        <translation>Alles, was in einer Kugel um einen Punkt der Oberfläche liegt, fassen</translation>
    </message>
    <message>
        <source>Grab a Bloc&amp;k</source>
        <translation>&amp;Quader fassen</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a block around a point on the surface</source>
        <translation>Alles, was in einem Quader um einen Punkt der Oberfläche liegt, fassen</translation>
    </message>
    <message>
        <source>Grab &amp;One Side</source>
        <translation>&amp;Eine Seite fassen</translation>
    </message>
    <message>
        <source>Take hold of all that lies beyond a plane through a point on the surface</source>
        <translation>Alles, was jenseits einer Ebene durch einen Punkt der Oberfläche liegt, fassen</translation>
    </message>
    <message>
        <source>&amp;Detail Brush</source>
        <translation>&amp;Feinheitspinsel</translation>
    </message>
    <message>
        <source>Brush where the mesh should be finer or coarser</source>
        <translation>Aufmalen, wo das Netz feiner oder gröber sein soll</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Malen</translation>
    </message>
    <message>
        <source>Paint what is kept, or how stiff it is</source>
        <translation>Malen, was erhalten bleibt oder wie steif es ist</translation>
    </message>
    <message>
        <source>&amp;Comb</source>
        <translation>&amp;Kämmen</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Die Richtung kämmen, in der es steif ist</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Drag to blend evenly from what is there to what is chosen</source>
        <translation>Ziehen: was dort ist, geht gleichmäßig in das Gewählte über</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Füllen</translation>
    </message>
    <message>
        <source>Fill a connected area with what is chosen</source>
        <translation>Alles, was zusammenhängt, mit dem Gewählten füllen</translation>
    </message>
    <message>
        <source>E&amp;yedropper</source>
        <translation>&amp;Pipette</translation>
    </message>
    <message>
        <source>Pick up what is painted under the pointer</source>
        <translation>Aufnehmen, was unter dem Zeiger gemalt ist</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>M&amp;essen</translation>
    </message>
    <message>
        <source>Outline by &amp;Lasso</source>
        <translation>Umriss mit dem &amp;Lasso</translation>
    </message>
    <message>
        <source>Draw around what should bend, or should not</source>
        <translation>Umfahren, was sich biegen soll oder was nicht</translation>
    </message>
    <message>
        <source>Outline by &amp;Polygon</source>
        <translation>Umriss als &amp;Vieleck</translation>
    </message>
    <message>
        <source>Set the corners of what should bend, or should not</source>
        <translation>Die Ecken dessen setzen, was sich biegen soll oder nicht</translation>
    </message>
    <message>
        <source>Outline by &amp;Brush</source>
        <translation>Umriss mit dem &amp;Pinsel</translation>
    </message>
    <message>
        <source>Brush over what should bend, or should not</source>
        <translation>Überstreichen, was sich biegen soll oder was nicht</translation>
    </message>
    <message>
        <source>Click a colour that should bend, or should not</source>
        <translation>Auf eine Farbe klicken, die sich biegen soll oder nicht</translation>
    </message>
    <message>
        <source>Cut &amp;Apart</source>
        <translation>&amp;Zertrennen</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape</source>
        <translation>Eine Linie zeichnen, an der die Form getrennt wird</translation>
    </message>
    <message>
        <source>Depth Brus&amp;h</source>
        <translation>&amp;Tiefenpinsel</translation>
    </message>
    <message>
        <source>Brush over what lies in front where the shape covers itself</source>
        <translation>Überstreichen, was vorn liegt, wo die Form sich selbst verdeckt</translation>
    </message>
    <message>
        <source>Measure lengths and angles between points of the shape</source>
        <translation>Längen und Winkel zwischen Punkten der Form messen</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>&amp;Radierer</translation>
    </message>
    <message>
        <source>Erase paint: what you brush over is like the rest again</source>
        <translation>Farbe wegnehmen: Überstrichenes ist wieder wie überall</translation>
    </message>
    <message>
        <source>&amp;Crop</source>
        <translation>&amp;Zuschneiden</translation>
    </message>
    <message>
        <source>Draw a rectangle around the part of the picture that exports keep</source>
        <translation>Ein Rechteck um das ziehen, was Exporte vom Bild behalten</translation>
    </message>
    <message>
        <source>Pe&amp;n</source>
        <translation>&amp;Zeichenfeder</translation>
    </message>
    <message>
        <source>Draw the path of a pin, point by point</source>
        <translation>Den Weg eines Pins Punkt für Punkt zeichnen</translation>
    </message>
    <message>
        <source>Pa&amp;n</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Drag the view to another place; in every step, holding the space bar does so, too</source>
        <translation>Die Ansicht verschieben; in jedem Schritt tut es die Leertaste</translation>
    </message>
    <message>
        <source>Magic &amp;Wand</source>
        <translation>&amp;Zauberstab</translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>This picture is no SVG drawing: its pixels are what it has.</source>
        <translation>Dieses Bild ist keine SVG-Zeichnung: Seine Pixel stehen fest.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Write the bent picture at its full size</source>
        <translation>Das Bild, wie es jetzt gebogen ist, in voller Größe schreiben</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation>Das gebogene Netz als OBJ, PLY, VTU … schreiben</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation>Schreiben, woher jedes Pixel kommt, für Compositing-Programme</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation>Die Datei schließen und zur Startseite zurückkehren</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation>Wend verlassen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>Beispi&amp;el öffnen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>Zurückgenommenes wiederholen</translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation>&amp;Alle Pins auswählen</translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation>Alle Pins auswählen</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>&amp;Keinen auswählen</translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation>Keinen Pin auswählen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>Pins &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation>Die ausgewählten Pins entfernen; was sich schon bewegt hat, bleibt</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation>Das bloße Bild zeigen; H gedrückt halten zeigt es für einen Moment</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Das ganze Bild zeigen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation>&amp;Originalgröße</translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation>Ein Pixel des Bildes auf einem des Bildschirms</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation>Näher heran</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>See more</source>
        <translation>Mehr sehen</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>V&amp;ollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Den ganzen Bildschirm nutzen</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Wie der &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>Light or dark, like the desktop</source>
        <translation>Hell oder dunkel, wie der Schreibtisch ist</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Dunkel auf Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Hell auf Dunkel</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Schleife</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>Zum &amp;Anfang</translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation>Die Form in Ruhe zeigen</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Was Zeiger und Tasten tun</translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation>Ü&amp;ber Wend</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>&amp;Erscheinungsbild</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>Be&amp;wegung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Zuerst ein Bild öffnen.</translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation>Dieses Projekt hat kein Bild.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Zuerst einen Pin auswählen.</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Noch bewegt sich nichts: einen Pin ziehen.</translation>
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
        <source>A solid has no pixels.</source>
        <translation>Ein Körper hat keine Pixel.</translation>
    </message>
    <message>
        <source>Open a picture, a mesh, a surface or a project</source>
        <translation>Ein Bild, ein Netz, eine Oberfläche oder ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Write the view as a picture, as large as you like</source>
        <translation>Die Ansicht als Bild schreiben, so groß wie gewünscht</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Show the end of the motion</source>
        <translation>Das Ende der Bewegung zeigen</translation>
    </message>
    <message>
        <source>Let the shape relax at the end, with the pins where they are</source>
        <translation>Die Form am Ende zur Ruhe hin entspannen, mit den Pins, wo sie sind</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Bild …</translation>
    </message>
    <message>
        <source>&amp;Sequence…</source>
        <translation>&amp;Bildfolge …</translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures or meshes</source>
        <translation>Die Bewegung als Folge von Bildern oder Netzen schreiben</translation>
    </message>
    <message>
        <source>&amp;Mesh…</source>
        <translation>&amp;Netz …</translation>
    </message>
    <message>
        <source>&amp;View…</source>
        <translation>&amp;Ansicht …</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>A solid has no pixels: export the view.</source>
        <translation>Ein Körper hat keine Pixel: exportieren Sie die Ansicht.</translation>
    </message>
    <message>
        <source>For a picture, export the picture itself.</source>
        <translation>Exportieren Sie von einem Bild das Bild selbst.</translation>
    </message>
    <message>
        <source>&amp;Stiffness Marks</source>
        <translation>&amp;Steifigkeitsmarken</translation>
    </message>
    <message>
        <source>Show where the shape is stiff, and along which direction</source>
        <translation>Zeigen, wo es steif ist und in welcher Richtung</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Colour the shape by what changed</source>
        <translation>Die Form danach färben, was sich geändert hat</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>&amp;Vorher</translation>
    </message>
    <message>
        <source>Show the shape as it was before it was bent; hold \ to do so for a moment</source>
        <translation>Die Form zeigen, wie sie vor dem Biegen war; für einen Augenblick \ halten</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>How it works, page by page, with a search</source>
        <translation>Wie es geht, Seite für Seite, mit einer Suche</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>&amp;Einführung</translation>
    </message>
    <message>
        <source>The first five minutes, on a sample, step by step</source>
        <translation>Die ersten fünf Minuten an einem Beispiel, Schritt für Schritt</translation>
    </message>
    <message>
        <source>&amp;Velocity Arrows</source>
        <translation>&amp;Geschwindigkeitspfeile</translation>
    </message>
    <message>
        <source>Show where the shape moves at this time</source>
        <translation>Zeigen, wohin sich die Form zu dieser Zeit bewegt</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>&amp;Compare Energies</source>
        <translation>&amp;Erhalt vergleichen</translation>
    </message>
    <message>
        <source>Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape</source>
        <translation>Daneben zeigen, was bei anderem Erhalt aus denselben Pins wird; oder eine Kachel von Erhalt auf die Form ziehen</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Auf&amp;nehmen</translation>
    </message>
    <message>
        <source>Record every drag as it happens, in real time; Ctrl does so for one drag</source>
        <translation>Jedes Ziehen wird aufgenommen, wie es geschieht, in Echtzeit; Strg tut das für ein Mal</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation>&amp;Zwiebelhaut</translation>
    </message>
    <message>
        <source>Show the shape as it was a little before and as it is a little after</source>
        <translation>Zeigen, was kurz davor war und was kurz danach kommt</translation>
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
        <translation>Wie schnell abgespielt und nach welcher Uhr aufgenommen wird</translation>
    </message>
    <message>
        <source>Speed: %1 %</source>
        <translation>Tempo: %1 %</translation>
    </message>
    <message>
        <source>Play or pause the motion; tapping the space bar does so, too</source>
        <translation>Die Bewegung abspielen oder anhalten; auch durch Antippen der Leertaste</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>&amp;Eigenschaften</translation>
    </message>
    <message>
        <source>Show the properties on the right, or give their room to the shape</source>
        <translation>Die Eigenschaften rechts zeigen oder ihren Platz der Form lassen</translation>
    </message>
    <message>
        <source>Size of M&amp;arks</source>
        <translation>&amp;Größe der Zeichen</translation>
    </message>
    <message>
        <source>How large pins, rings and curves are drawn, so that they are easy to see and to hit</source>
        <translation>Wie groß Pins, Ringe und Kurven über der Form sind, für das Auge und für die Hand</translation>
    </message>
    <message>
        <source>Rela&amp;x</source>
        <translation>&amp;Entspannen</translation>
    </message>
    <message>
        <source>ST &amp;Map…</source>
        <translation>ST-&amp;Map …</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Protokoll …</translation>
    </message>
    <message>
        <source>Show the undo history, and go back to any step</source>
        <translation>Das Protokoll der Schritte zeigen und zu jedem zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>Show the edges of the mesh</source>
        <translation>Die Kanten des Netzes zeigen</translation>
    </message>
    <message>
        <source>&amp;Colour Overlay</source>
        <translation>&amp;Farbüberlagerung</translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Overlays</source>
        <translation>Pins und Überlagerungen &amp;verbergen</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Film …</translation>
    </message>
    <message>
        <source>Write the motion as a film: MP4, WebM, QuickTime, GIF …</source>
        <translation>Die Bewegung als Film schreiben: MP4, WebM, QuickTime, GIF …</translation>
    </message>
    <message>
        <source>&amp;Pose at This Time</source>
        <translation>&amp;Pose zu dieser Zeit</translation>
    </message>
    <message>
        <source>In the step Animate, a drag sets where pins are at the time shown, and what they do before and after stays; off: it leads them on to the end of the film</source>
        <translation>Im Schritt Animieren setzt ein Ziehen, wo Pins zur gezeigten Zeit sind, und was sie davor und danach tun, bleibt; aus: Es führt sie weiter bis zum Ende des Films</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>&amp;Teil machen</translation>
    </message>
    <message>
        <source>What is drawn as the outline becomes a part that bends by itself, or what you draw next; what is behind it is filled</source>
        <translation>Was als Umriss gezeichnet ist, oder als Nächstes gezeichnet wird, wird ein Teil, das sich allein biegt; was dahinter liegt, wird gefüllt</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Keep the Pa&amp;th</source>
        <translation>&amp;Weg behalten</translation>
    </message>
    <message>
        <source>Re&amp;place Picture…</source>
        <translation>Bild er&amp;setzen …</translation>
    </message>
    <message>
        <source>Bend another picture of the same proportions in the place of this one; pins and motions stay, and are scaled if it is larger or smaller</source>
        <translation>Ein anderes Bild mit denselben Proportionen an seiner Stelle verbiegen; Pins und Bewegungen bleiben und werden angepasst, wenn es größer oder kleiner ist</translation>
    </message>
    <message>
        <source>&amp;Apply Motion…</source>
        <translation>Bewegung &amp;übernehmen …</translation>
    </message>
    <message>
        <source>Move this shape as another project moves its own: pins of the same name, with lengths in proportion to the sizes of both shapes</source>
        <translation>Diese Form bewegen wie ein anderes Projekt die seine: gleichnamige Pins, mit Längen im Verhältnis der Größen beider Formen</translation>
    </message>
    <message>
        <source>A drag that follows another of the same pins at the end of the film leads them on by a second; off: it corrects that move, which becomes straight</source>
        <translation>Ein Zug, der am Ende des Films auf einen anderen derselben Pins folgt, führt sie eine Sekunde weiter; aus: Er berichtigt diese Bewegung, die gerade wird</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>&amp;Tastenkürzel …</translation>
    </message>
    <message>
        <source>Give actions other keys</source>
        <translation>Befehlen andere Tasten geben</translation>
    </message>
    <message>
        <source>&amp;Drawing Size…</source>
        <translation>&amp;Größe der Zeichnung …</translation>
    </message>
    <message>
        <source>Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it</source>
        <translation>Die SVG-Zeichnung mit mehr oder weniger Pixeln zeichnen; Pins und Bewegungen werden angepasst</translation>
    </message>
</context>
<context>
    <name>wend::BackdropChoice</name>
    <message>
        <source>Bac&amp;kdrop</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>&amp;Karos</translation>
    </message>
    <message>
        <source>Checks behind a picture, the workspace behind a solid</source>
        <translation>Karos hinter einem Bild, die Arbeitsfläche hinter einem Körper</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>&amp;Weiß</translation>
    </message>
    <message>
        <source>White behind the shape, to see dark edges</source>
        <translation>Weiß hinter der Form: Darauf sieht man dunkle Ränder</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>Grey behind the shape</source>
        <translation>Grau hinter der Form</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Schwarz</translation>
    </message>
    <message>
        <source>Black behind the shape, to see light edges</source>
        <translation>Schwarz hinter der Form: Darauf sieht man helle Ränder</translation>
    </message>
</context>
<context>
    <name>wend::BalancePanel</name>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Dieses Projekt glättet wie im Aufsatz mit λ; seine Datei sagt, wie viel.</translation>
    </message>
</context>
<context>
    <name>wend::BrushActions</name>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>%1 malen</translation>
    </message>
    <message>
        <source>Choose the step “Paint” first.</source>
        <translation>Zuerst den Schritt „Malen“ wählen.</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Erhalt</translation>
    </message>
    <message>
        <source>Paint what the shape keeps when it has to give way</source>
        <translation>Malen, was die Form erhält, wenn sie nachgeben muss</translation>
    </message>
    <message>
        <source>&amp;Stiffness</source>
        <translation>&amp;Steifigkeit</translation>
    </message>
    <message>
        <source>Paint how many times stiffer the shape is along a direction</source>
        <translation>Malen, wievielmal steifer die Form in einer Richtung ist</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Richtung</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Die Richtung kämmen, in der die Form steif ist</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ], or by dragging to the right with Alt and the right button.</source>
        <translation>Der Durchmesser des Pinsels auf dem Bildschirm; auch mit den Tasten [ und ], oder mit Alt und der rechten Taste nach rechts ziehen.</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>How much of the brush paints fully; beyond that it fades out. Also by Shift with [ and ], or by dragging upwards with Alt and the right button.</source>
        <translation>Wie viel des Pinsels ganz malt; weiter außen läuft er aus. Auch mit Umschalt und [ oder ], oder mit Alt und der rechten Taste nach oben ziehen.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>How far a stroke goes from what is there to what is painted.</source>
        <translation>Wie weit ein Strich von dem, was da ist, zum Gemalten geht.</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Druck</translation>
    </message>
    <message>
        <source>The harder a pen is pressed, the more of the amount is painted</source>
        <translation>Je fester ein Stift gedrückt wird, desto mehr von der Menge wird gemalt</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>What you brush over lies in front if this is greater than 0, behind if it is less</source>
        <translation>Was überstrichen wird, liegt vorn, wo sie größer als 0 ist, hinten, wo sie kleiner ist</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>How long the mesh&apos;s edges are where you brush, compared with elsewhere</source>
        <translation>Wie lang die Kanten des Netzes sind, wo überstrichen wird, gemessen an denen sonst</translation>
    </message>
</context>
<context>
    <name>wend::CheatSheet</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
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
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>angle %1 · volume %2 · stretch %3</source>
        <translation>Winkel %1 · Volumen %2 · Dehnung %3</translation>
    </message>
    <message>
        <source>angle %1 · area %2 · stretch %3</source>
        <translation>Winkel %1 · Fläche %2 · Dehnung %3</translation>
    </message>
    <message>
        <source>The same with another energy</source>
        <translation>Dasselbe mit anderem Erhalt</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>Shows one shape again.</source>
        <translation>Zeigt wieder eine einzige Form.</translation>
    </message>
    <message>
        <source>What this half keeps, or how it is without paint, with the same pins and motions.</source>
        <translation>Was diese Hälfte erhält, oder wie sie ohne Bemalung ist, mit denselben Pins und Bewegungen.</translation>
    </message>
    <message>
        <source>Nothing painted</source>
        <translation>Ohne Bemalung</translation>
    </message>
</context>
<context>
    <name>wend::CurveActions</name>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Kurve</translation>
    </message>
    <message>
        <source>Turn the last path of the selected pin into a Bézier curve</source>
        <translation>Aus dem letzten Weg des gewählten Pins eine Bézierkurve machen</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>&amp;Insert Point</source>
        <translation>Punkt &amp;einfügen</translation>
    </message>
    <message>
        <source>Split the curve at the pointer, or after the chosen point; its shape stays</source>
        <translation>Die Kurve teilen, wo auf sie gezeigt wurde oder hinter dem gewählten Punkt; ihre Form bleibt</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>Punkt &amp;löschen</translation>
    </message>
    <message>
        <source>Remove the chosen point from the curve</source>
        <translation>Den gewählten Punkt aus der Kurve nehmen</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>&amp;Frei</translation>
    </message>
    <message>
        <source>Let the two directions at the point be independent</source>
        <translation>Beide Richtungen am Punkt gehen ihren eigenen Weg</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>&amp;Aligned</source>
        <translation>&amp;Ausgerichtet</translation>
    </message>
    <message>
        <source>Keep both directions at the point on one line</source>
        <translation>Beide Richtungen am Punkt bleiben auf einer Geraden</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomatisch</translation>
    </message>
    <message>
        <source>Lead the curve smoothly through the point, guided by its neighbours</source>
        <translation>Die Kurve nach ihren Nachbarn glatt durch den Punkt führen</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>Select one pin that was dragged along a path.</source>
        <translation>Erst einen Pin auswählen, der einen Weg gezogen wurde.</translation>
    </message>
    <message>
        <source>Select one pin that follows a curve.</source>
        <translation>Erst einen Pin auswählen, der einer Kurve folgt.</translation>
    </message>
    <message>
        <source>Click a point of the curve first; two must remain.</source>
        <translation>Erst einen Punkt der Kurve anklicken; zwei müssen bleiben.</translation>
    </message>
    <message>
        <source>Click an inner point of a Bézier curve first.</source>
        <translation>Erst einen inneren Punkt einer Bézierkurve anklicken.</translation>
    </message>
    <message>
        <source>Edit &amp;Path</source>
        <translation>&amp;Weg bearbeiten</translation>
    </message>
</context>
<context>
    <name>wend::CurvePanel</name>
    <message>
        <source>Turns the drawn path into a Bézier curve with points to drag.</source>
        <translation>Macht aus dem gezogenen Weg eine Bézierkurve mit Punkten zum Ziehen.</translation>
    </message>
    <message>
        <source>Whether what is held turns along the curve, and how.</source>
        <translation>Ob sich das Gehaltene entlang der Kurve dreht, und wie.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Drall</translation>
    </message>
    <message>
        <source>How far it turns around the curve&apos;s direction, over the whole curve.</source>
        <translation>Wie weit es sich über die ganze Kurve um deren Richtung dreht.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How large it has become at the end of the curve.</source>
        <translation>Wie groß es am Ende der Kurve geworden ist.</translation>
    </message>
    <message>
        <source>T&amp;wist</source>
        <translation>D&amp;rall</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Kurve ändern</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow: hold more vertices.</source>
        <translation>Ein Punkt kann sich nicht drehen oder wachsen: mehr Punkte greifen.</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>Weg bearbeiten</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>as it bends (Frenet)</source>
        <translation>wie er sich biegt (Frenet)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Rotate with path</source>
        <translation>Am Weg ausrichten</translation>
    </message>
    <message>
        <source>Rot&amp;ate with path</source>
        <translation>Mit dem Weg drehe&amp;n</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Easing</translation>
    </message>
    <message>
        <source>How the motion at the shown time starts and ends.</source>
        <translation>Wie die Bewegung zur gezeigten Zeit beginnt und endet.</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Easing ändern</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow – drag its ring, or give it a radius.</source>
        <translation>Ein Punkt kann sich nicht drehen oder wachsen – ziehen Sie seinen Ring, oder geben Sie ihm einen Radius.</translation>
    </message>
</context>
<context>
    <name>wend::CutOutPanel</name>
    <message>
        <source>Only a cut-out has this. An outline that you have drawn stays as you drew it.</source>
        <translation>Das hat nur ein Ausschnitt. Ein gezeichneter Umriss bleibt, wie er gezeichnet ist.</translation>
    </message>
</context>
<context>
    <name>wend::CutPanel</name>
    <message>
        <source>Not cut</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Whole cells</source>
        <translation>Ganze Zellen</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Looks inside: by whole tetrahedra, or along the exact plane.</source>
        <translation>Zeigt das Innere: in ganzen Tetraedern oder genau entlang der Ebene.</translation>
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
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>Quer zu %1 schneiden</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Turns the plane so that it is perpendicular to this axis.</source>
        <translation>Stellt die Ebene quer zu dieser Achse.</translation>
    </message>
    <message>
        <source>Cuts away the other side of the plane.</source>
        <translation>Nimmt die andere Seite der Ebene weg.</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Ort des Schnitts</translation>
    </message>
    <message>
        <source>Moves the plane through the solid.</source>
        <translation>Verschiebt die Ebene durch den Körper.</translation>
    </message>
    <message>
        <source>Normal of the cut</source>
        <translation>Normale des Schnitts</translation>
    </message>
    <message>
        <source>The direction that the plane faces, as x, y and z.</source>
        <translation>Die Richtung, in die die Ebene schaut, als x, y und z.</translation>
    </message>
    <message>
        <source>Distance of the cut</source>
        <translation>Abstand des Schnitts</translation>
    </message>
    <message>
        <source>How far the plane is from the origin, along its normal.</source>
        <translation>Wie weit die Ebene entlang ihrer Normalen vom Ursprung entfernt ist.</translation>
    </message>
    <message>
        <source>&amp;Look inside</source>
        <translation>Hinein&amp;sehen</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>Abs&amp;tand</translation>
    </message>
    <message>
        <source>There is no solid to cut yet.</source>
        <translation>Es gibt noch keinen Körper, der sich schneiden ließe.</translation>
    </message>
</context>
<context>
    <name>wend::DepthActions</name>
    <message>
        <source>Bring to &amp;Front</source>
        <translation>Nach &amp;vorn</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies in front of all else</source>
        <translation>Wo die Form sich selbst verdeckt, liegt vor allem anderen, was um die gewählten Pins ist</translation>
    </message>
    <message>
        <source>Ctrl+Shift+]</source>
        <translation>Ctrl+Shift+]</translation>
    </message>
    <message>
        <source>Send to &amp;Back</source>
        <translation>Nach &amp;hinten</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies behind all else</source>
        <translation>Wo die Form sich selbst verdeckt, liegt hinter allem anderen, was um die gewählten Pins ist</translation>
    </message>
    <message>
        <source>Ctrl+Shift+[</source>
        <translation>Ctrl+Shift+[</translation>
    </message>
    <message>
        <source>As &amp;Drawn</source>
        <translation>Wie &amp;gezeichnet</translation>
    </message>
    <message>
        <source>What is around the selected pins has no order of its own</source>
        <translation>Was um die gewählten Pins ist, hat keine eigene Ordnung</translation>
    </message>
    <message>
        <source>&amp;Number…</source>
        <translation>&amp;Zahl …</translation>
    </message>
    <message>
        <source>Give what is around the selected pins an order: the greater number lies in front</source>
        <translation>Dem, was um die gewählten Pins ist, eine Ordnung geben: Größeres liegt vorn</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source>A solid has depth of its own.</source>
        <translation>Ein Körper hat seine Tiefe von selbst.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Zuerst einen Pin wählen.</translation>
    </message>
    <message>
        <source>Bring to front</source>
        <translation>Nach vorn bringen</translation>
    </message>
    <message>
        <source>Send to back</source>
        <translation>Nach hinten bringen</translation>
    </message>
    <message>
        <source>Depth as drawn</source>
        <translation>Tiefe wie gezeichnet</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Order (in front: greater than 0, behind: less):</source>
        <translation>Ordnung (vorn: größer als 0, hinten: kleiner):</translation>
    </message>
</context>
<context>
    <name>wend::DetailChooser</name>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Oberflächen (%1)</translation>
    </message>
    <message>
        <source>This surface cannot be embedded in the solid. %1</source>
        <translation>Diese Oberfläche kann im Körper nicht mitreiten. %1</translation>
    </message>
    <message>
        <source>Choose Skin</source>
        <translation>Haut wählen</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Haut wählen</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Haut entfernen</translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Angle error</source>
        <translation>Winkelfehler</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation>Summe über die Form von σ₁/σ₂ + σ₂/σ₁ − 2: null, wenn alle Winkel gehalten sind.</translation>
    </message>
    <message>
        <source>Area error</source>
        <translation>Flächenfehler</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation>Summe über die Form von σ₁σ₂ + 1/(σ₁σ₂) − 2: null, wenn alle Flächen gehalten sind.</translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation>Wie weit die Längen von denen in Ruhe abweichen: null bei starrer Bewegung.</translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation>Schlimmste Stelle</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>Volumenfehler</translation>
    </message>
    <message>
        <source>Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.</source>
        <translation>Summe von det F + 1/det F − 2 über die Form: null, wenn alle Volumen erhalten sind.</translation>
    </message>
    <message>
        <source>Go to the worst place</source>
        <translation>Zur schlimmsten Stelle gehen</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>Colour &amp;by</source>
        <translation>Färben &amp;nach</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>&amp;Deckkraft</translation>
    </message>
    <message>
        <source>What is coloured over the solid: the error of lengths, volumes or angles, how far it is from where it was, the material, how fast it moves, or how fine its mesh is.</source>
        <translation>Was über den Körper gefärbt wird: der Fehler von Längen, Volumen oder Winkeln, wie weit er von seinem Ort entfernt ist, das Material, wie schnell er sich bewegt oder wie fein sein Netz ist.</translation>
    </message>
    <message>
        <source>What is coloured over the picture: the error of lengths, areas or angles, how far it is from where it was, the material, or how fast it moves.</source>
        <translation>Was über das Bild gefärbt wird: der Fehler von Längen, Flächen oder Winkeln, wie weit es von seinem Ort entfernt ist, das Material oder wie schnell es sich bewegt.</translation>
    </message>
    <message>
        <source>Smooth colo&amp;urs</source>
        <translation>Glatte Far&amp;ben</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>Entartet</translation>
    </message>
    <message>
        <source>Passes through itself</source>
        <translation>Durchdringt sich</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>Überkreuzt sich</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nirgends</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 Stelle</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n Stelle</numerusform>
            <numerusform>%n Stellen</numerusform>
        </translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 Zelle</translation>
    </message>
    <message numerus="yes">
        <source>%n cells</source>
        <translation>
            <numerusform>%n Zelle</numerusform>
            <numerusform>%n Zellen</numerusform>
        </translation>
    </message>
    <message>
        <source>This is checked once the pose is at rest.</source>
        <translation>Danach wird gesucht, sobald die Pose ruht.</translation>
    </message>
    <message>
        <source>There is no such place.</source>
        <translation>Eine solche Stelle gibt es nicht.</translation>
    </message>
    <message>
        <source>No place is farther from rest than another.</source>
        <translation>Keine Stelle ist weiter von der Ruhe entfernt als eine andere.</translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation>Pinfehler</translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation>Wie weit der schlechteste Pin von seinem Ort entfernt ist</translation>
    </message>
    <message>
        <source>Computing time</source>
        <translation>Rechenzeit</translation>
    </message>
    <message>
        <source>How long the shown shape took to compute</source>
        <translation>Wie lange die Berechnung der gezeigten Form gedauert hat</translation>
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
        <translation>Skala sperren</translation>
    </message>
    <message>
        <source>How much the overlay covers the picture, or the colours of the solid, below it.</source>
        <translation>Wie stark die Überlagerung das Bild oder die Farben des Körpers darunter deckt.</translation>
    </message>
    <message>
        <source>Blends the colours of the overlay from cell to cell. If off, each cell has the one colour of its value.</source>
        <translation>Lässt die Farben der Überlagerung gleichmäßig von Zelle zu Zelle übergehen. Aus hat jede Zelle die eine Farbe ihres Werts.</translation>
    </message>
    <message>
        <source>Keeps the range of the colours, to compare different shapes and energies.</source>
        <translation>Hält den Bereich der Farben fest, um Formen und Energien zu vergleichen.</translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the overlay.</source>
        <translation>Rückt das am stärksten verzerrte Dreieck ins Bild; in der Überlagerung ist es eingekreist.</translation>
    </message>
    <message>
        <source>The tetrahedron that is farthest from rest in what the overlay shows.</source>
        <translation>Das Tetraeder, das nach dem, was die Überlagerung zeigt, am weitesten von der Ruhe entfernt ist.</translation>
    </message>
    <message>
        <source>The triangle that is farthest from rest in what the overlay shows.</source>
        <translation>Das Dreieck, das nach dem, was die Überlagerung zeigt, am weitesten von der Ruhe entfernt ist.</translation>
    </message>
    <message>
        <source>In how many places the surface passes through itself once the pose is at rest, each with its pairs of triangles. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Wie oft die Oberfläche sich durchdringt, sobald die Pose ruht: Stellen, jede aus Paaren von Dreiecken. Ein Klick zeigt die nächste; die Überlagerung zeigt sie rot.</translation>
    </message>
    <message>
        <source>Where the outline crosses itself once the pose is at rest: one part lies over another. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Wo der Umriss sich überkreuzt, sobald die Pose ruht: Ein Teil liegt über einem anderen. Ein Klick zeigt die nächste Stelle; die Überlagerung zeigt sie rot.</translation>
    </message>
    <message>
        <source>Tetrahedra with more than ten times their volume, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Tetraeder mit mehr als dem Zehnfachen ihres Volumens oder weniger als einem Zehntel davon. Ein Klick zeigt die nächste Stelle; die Überlagerung zeigt sie rot.</translation>
    </message>
    <message>
        <source>Triangles with more than ten times their area, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Dreiecke mit mehr als dem Zehnfachen ihrer Fläche oder weniger als einem Zehntel davon. Ein Klick zeigt die nächste Stelle; die Überlagerung zeigt sie rot.</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Farben von</translation>
    </message>
    <message>
        <source>The value of the first colour. A typed value locks the scale; “≤” in the legend says that some places have less.</source>
        <translation>Der Wert der ersten Farbe. Ein eingegebener Wert hält die Skala fest; „≤“ in der Legende heißt, dass Stellen darunter liegen.</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>Farben bis</translation>
    </message>
    <message>
        <source>The value of the last colour. A typed value locks the scale; “≥” in the legend says that some places have more.</source>
        <translation>Der Wert der letzten Farbe. Ein eingegebener Wert hält die Skala fest; „≥“ in der Legende heißt, dass Stellen darüber liegen.</translation>
    </message>
    <message>
        <source>Spreads the colours evenly over the orders of magnitude of the values.</source>
        <translation>Verteilt die Farben gleichmäßig über die Größenordnungen der Werte.</translation>
    </message>
    <message>
        <source>Colours from, to</source>
        <translation>Farben von, bis</translation>
    </message>
    <message>
        <source>These colours are those of the four energies.</source>
        <translation>Diese Farben sind die der vier Energien.</translation>
    </message>
    <message>
        <source>The scale of this measure is fixed.</source>
        <translation>Die Skala dieses Maßes liegt fest.</translation>
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
        <translation>Größe der Zeichnung</translation>
    </message>
    <message>
        <source>The drawing becomes a picture of this size. Pins, paths and regions are scaled with it; exported SVG files keep the drawing&apos;s own units.</source>
        <translation>Die Zeichnung wird ein Bild dieser Größe. Pins, Pfade und Bereiche werden angepasst; exportierte SVG-Dateien behalten die Einheiten der Zeichnung.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>Of the size at which the drawing is opened</source>
        <translation>Der Größe, in der die Zeichnung geöffnet wird</translation>
    </message>
</context>
<context>
    <name>wend::EaseEditor</name>
    <message>
        <source>Easing Curve</source>
        <translation>Easing-Kurve</translation>
    </message>
    <message>
        <source>Speed at the &amp;start</source>
        <translation>Tempo am &amp;Anfang</translation>
    </message>
    <message>
        <source>Speed at the &amp;end</source>
        <translation>Tempo am &amp;Ende</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>In percent of the speed of an even move: at 0 % the pin stops there.</source>
        <translation>In Prozent des Tempos einer gleichmäßigen Bewegung: Bei 0 % steht der Pin dort still.</translation>
    </message>
    <message>
        <source>Speed at the start</source>
        <translation>Tempo am Anfang</translation>
    </message>
    <message>
        <source>Speed at the end</source>
        <translation>Tempo am Ende</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>The pin stays where it was, and goes on from there afterwards.</source>
        <translation>Der Pin bleibt, wo er war, und geht danach von dort weiter.</translation>
    </message>
    <message>
        <source>Choose a bar or a key in the tracks.</source>
        <translation>Einen Balken oder eine Schlüsselpose in den Spuren wählen.</translation>
    </message>
    <message>
        <source>Rotations and scalings have one of the four easings.</source>
        <translation>Drehungen und Skalierungen haben eines der vier Easings.</translation>
    </message>
    <message>
        <source>1 motion</source>
        <translation>1 Bewegung</translation>
    </message>
    <message numerus="yes">
        <source>%n motions</source>
        <translation>
            <numerusform>%n Bewegung</numerusform>
            <numerusform>%n Bewegungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::EasePlot</name>
    <message>
        <source>Easing curve</source>
        <translation>Easing-Kurve</translation>
    </message>
    <message>
        <source>How far the pin has come over time. Drag the two handles up or down; Left and Right choose one, Up and Down move it.</source>
        <translation>Wie weit der Pin im Lauf der Zeit gekommen ist. Die beiden Griffe auf oder ab ziehen; Links und Rechts wählen einen, Auf und Ab bewegen ihn.</translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>What the shape keeps where it has to give way: from its volume, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Was die Form behält, wo sie nachgeben muss: vom Volumen über Längen und starre Teile bis zum Aussehen der Einzelheiten. Zwischen zwei Namen ist es etwas von beidem.</translation>
    </message>
    <message>
        <source>What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Was die Form behält, wo sie nachgeben muss: von der Fläche über Längen und starre Teile bis zum Aussehen der Einzelheiten. Zwischen zwei Namen ist es etwas von beidem.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
</context>
<context>
    <name>wend::ExportDialog</name>
    <message>
        <source>Export Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Export Sequence</source>
        <translation>Bildfolge exportieren</translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation>ST-Map exportieren</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Film exportieren</translation>
    </message>
</context>
<context>
    <name>wend::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>Welche Art von Datei geschrieben wird.</translation>
    </message>
    <message>
        <source>Fit the Can&amp;vas</source>
        <translation>Leinwand an&amp;passen</translation>
    </message>
    <message>
        <source>Fit the canvas</source>
        <translation>Leinwand anpassen</translation>
    </message>
    <message>
        <source>Make the canvas as large as the shape needs, so that nothing is cut off.</source>
        <translation>Die Leinwand so groß machen, wie die Form es braucht, damit nichts abgeschnitten wird.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Wie im Bild</translation>
    </message>
    <message>
        <source>As it suits the format best</source>
        <translation>Wie das Format es am besten hält</translation>
    </message>
    <message>
        <source>%1 px on the left</source>
        <translation>%1 px links</translation>
    </message>
    <message>
        <source>%1 px at the top</source>
        <translation>%1 px oben</translation>
    </message>
    <message>
        <source>%1 px on the right</source>
        <translation>%1 px rechts</translation>
    </message>
    <message>
        <source>%1 px at the bottom</source>
        <translation>%1 px unten</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>As it moves, the shape leaves the picture and is cut off there: %1.</source>
        <translation>Unterwegs verlässt die Form das Bild und wird dort abgeschnitten: %1.</translation>
    </message>
    <message>
        <source>The shape reaches beyond the picture and is cut off there: %1.</source>
        <translation>Die Form reicht über das Bild hinaus und wird dort abgeschnitten: %1.</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Punkte</translation>
    </message>
    <message numerus="yes">
        <source>%n shapes of %1</source>
        <translation>
            <numerusform>%n Form mit %1</numerusform>
            <numerusform>%n Formen mit %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures of %1</source>
        <translation>
            <numerusform>%n Bild von %1</numerusform>
            <numerusform>%n Bilder von %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Zugeschnitten</translation>
    </message>
    <message>
        <source>%1 has no transparency: pictures are placed on white.</source>
        <translation>%1 kennt keine durchsichtigen Stellen: Bilder werden auf Weiß gesetzt.</translation>
    </message>
</context>
<context>
    <name>wend::ExportPanel</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>ST Map</source>
        <translation>ST-Map</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Choose a name and write what the preview shows.</source>
        <translation>Einen Namen wählen und schreiben, was die Vorschau zeigt.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
</context>
<context>
    <name>wend::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>What will be written, smaller</source>
        <translation>Was geschrieben wird, kleiner</translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>Die Form wird noch berechnet. Gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>Nichts wurde geschrieben. %1</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>Das Bild wird geschrieben …</translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation>Das Netz wird geschrieben …</translation>
    </message>
    <message>
        <source>Another export is still being written. Try again in a moment.</source>
        <translation>Ein anderer Export wird noch geschrieben. Bitte gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Written without velocities: %1 (%2)</source>
        <translation>Geschrieben ohne Geschwindigkeiten: %1 (%2)</translation>
    </message>
    <message>
        <source>There is no shape to export: it could not be computed.</source>
        <translation>Es gibt keine Form zum Exportieren: sie konnte nicht berechnet werden.</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n frames …</source>
        <translation>
            <numerusform>%n Bild wird geschrieben …</numerusform>
            <numerusform>%n Bilder werden geschrieben …</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is this project itself. Replace it?</source>
        <translation>„%1“ ist dieses Projekt selbst. Ersetzen?</translation>
    </message>
    <message>
        <source>“%1” is the picture that this project bends. Replace it?</source>
        <translation>„%1“ ist das Bild, das dieses Projekt biegt. Ersetzen?</translation>
    </message>
    <message>
        <source>“%1” is the mesh that this project bends. Replace it?</source>
        <translation>„%1“ ist das Netz, das dieses Projekt biegt. Ersetzen?</translation>
    </message>
    <message>
        <source>“%1” belongs to this project. Replace it?</source>
        <translation>„%1“ gehört zu diesem Projekt. Ersetzen?</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message numerus="yes">
        <source>Replace the frames that already exist (%n)?</source>
        <translation>
            <numerusform>%n dieser Bilder gibt es schon. Ersetzen?</numerusform>
            <numerusform>%n dieser Bilder gibt es schon. Ersetzen?</numerusform>
        </translation>
    </message>
    <message>
        <source>What it holds now will be lost, and the project will no longer open as it is.</source>
        <translation>Was sie jetzt enthält, geht verloren, und das Projekt öffnet sich nicht mehr so, wie es ist.</translation>
    </message>
    <message>
        <source>What they hold now will be lost.</source>
        <translation>Was sie jetzt enthalten, geht verloren.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Export Material</source>
        <translation>Material schreiben</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Bilder (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Writing the ST map …</source>
        <translation>Die ST-Map wird geschrieben …</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Der Film wird geschrieben …</translation>
    </message>
</context>
<context>
    <name>wend::FactsPanel</name>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>mean edge</source>
        <translation>mittlere Kante</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>boundary loops</source>
        <translation>Randschleifen</translation>
    </message>
    <message>
        <source>genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>crossing pairs</source>
        <translation>kreuzende Paare</translation>
    </message>
    <message>
        <source>Worst cell</source>
        <translation>Schlechteste Zelle</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>Nächster Spalt</translation>
    </message>
    <message>
        <source>Open the widest</source>
        <translation>Breitesten öffnen</translation>
    </message>
    <message>
        <source>Facts of the file</source>
        <translation>Angaben zur Datei</translation>
    </message>
    <message>
        <source>The surface as it is in its file. Lengths are in the file&apos;s units, which few files name.</source>
        <translation>Die Oberfläche, wie die Datei sie hat. Längen sind in der Einheit der Datei, die wenige nennen.</translation>
    </message>
    <message>
        <source>Quality of the cells</source>
        <translation>Güte der Zellen</translation>
    </message>
    <message>
        <source>Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are above that, and how many triangles of the surface force them.</source>
        <translation>Umkreisradius durch kürzeste Kante des schlechtesten Tetraeders, was verlangt war, wie viele darüber liegen und wie viele Dreiecke der Oberfläche sie erzwingen.</translation>
    </message>
    <message>
        <source>Closed gaps</source>
        <translation>Geschlossene Spalte</translation>
    </message>
    <message>
        <source>Gaps within one part that the cage closes: what lies on both sides moves together.</source>
        <translation>Spalte in einem Teil, die der Käfig schließt: Was auf beiden Seiten liegt, bewegt sich zusammen.</translation>
    </message>
    <message>
        <source>Goes to the tetrahedron with the largest ratio.</source>
        <translation>Blickt auf das Tetraeder mit dem größten Verhältnis.</translation>
    </message>
    <message>
        <source>Goes through the gaps that the cage closes, one after another.</source>
        <translation>Blickt nacheinander auf die Spalte, die der Käfig schließt.</translation>
    </message>
    <message>
        <source>Makes the cage so fine that the widest of these gaps stays open.</source>
        <translation>Macht den Käfig so fein, dass der breiteste dieser Spalte offen bleibt.</translation>
    </message>
    <message>
        <source>Looking at the file …</source>
        <translation>Die Datei wird angesehen …</translation>
    </message>
    <message>
        <source>Surface of the file</source>
        <translation>Oberfläche der Datei</translation>
    </message>
    <message>
        <source>worst ratio</source>
        <translation>schlechtestes Verhältnis</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>cells above</source>
        <translation>Zellen darüber</translation>
    </message>
    <message>
        <source>forced by triangles</source>
        <translation>erzwungen von Dreiecken</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>That would take more than a million vertices.</source>
        <translation>Das bräuchte mehr als eine Million Punkte.</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>closed gaps</source>
        <translation>geschlossene Spalte</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>schmalster</translation>
    </message>
    <message>
        <source>Open a gap</source>
        <translation>Spalt öffnen</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>wend::FileCard</name>
    <message>
        <source>Sample: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation>Das Beispiel „%1“ öffnen</translation>
    </message>
    <message>
        <source>%1, solid</source>
        <translation>%1, Körper</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Open the unsaved changes to “%1”</source>
        <translation>Die ungespeicherten Änderungen an „%1“ öffnen</translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation>Alles, was Wend öffnet (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Projekte (*.wend)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Netze (%1)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation>Diese Datei lässt sich nicht öffnen. %1</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation>Das Projekt wurde nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>If you do not save, they will be lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>Your changes cannot be recovered if the program crashes: please save. %1</source>
        <translation>Falls das Programm abstürzt, gibt es keine Kopie Ihrer Änderungen: bitte speichern. %1</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>%1 has moved.</source>
        <translation>%1 ist nicht mehr da, wo es war.</translation>
    </message>
    <message>
        <source>Find It…</source>
        <translation>Suchen …</translation>
    </message>
    <message>
        <source>Nothing to see in this picture.</source>
        <translation>In diesem Bild ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Use Whole Frame</source>
        <translation>Ganze Fläche nehmen</translation>
    </message>
    <message>
        <source>Open Another…</source>
        <translation>Ein anderes öffnen …</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>“%1” was changed by another program or window.</source>
        <translation>„%1“ wurde von einem anderen Programm oder Fenster geändert.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meines behalten</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>„%1“ neu laden?</translation>
    </message>
    <message>
        <source>Your changes since it was saved will be lost.</source>
        <translation>Ihre Änderungen seit dem Speichern gehen verloren.</translation>
    </message>
    <message>
        <source>Saving replaces those changes; reloading discards yours.</source>
        <translation>Speichern ersetzt jene Änderungen; neu laden verwirft Ihre.</translation>
    </message>
    <message>
        <source>The project was not saved: it needs the file “%1” itself. Choose another name.</source>
        <translation>Das Projekt wurde nicht gespeichert: Es braucht die Datei „%1“ selbst. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Wend was not closed properly: there are unsaved changes to “%1”.</source>
        <translation>Wend wurde nicht ordentlich beendet: Es gibt ungespeicherte Änderungen an „%1“.</translation>
    </message>
    <message>
        <source>Discard the unsaved changes to “%1”? They cannot be brought back.</source>
        <translation>Die ungespeicherten Änderungen an „%1“ verwerfen? Sie lassen sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save what you made of “%1”?</source>
        <translation>Speichern, was Sie aus „%1“ gemacht haben?</translation>
    </message>
    <message>
        <source>It becomes a project of its own; the file stays as it is. If you do not save, what you made will be lost.</source>
        <translation>Es wird ein eigenes Projekt; die Datei selbst bleibt, wie sie ist. Ohne Speichern geht das Gemachte verloren.</translation>
    </message>
    <message>
        <source>“%1” %2.</source>
        <comment>a file, and what is wrong with it</comment>
        <translation>„%1“ %2.</translation>
    </message>
    <message>
        <source>Pictures with layers (%1)</source>
        <translation>Bilder mit Ebenen (%1)</translation>
    </message>
</context>
<context>
    <name>wend::FilmPanel</name>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Choose sound</source>
        <translation>Ton auswählen</translation>
    </message>
    <message>
        <source>A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films.</source>
        <translation>Eine Datei, deren Ton mit der Bewegung beginnt und in MP4-, WebM- und QuickTime-Filme kommt.</translation>
    </message>
    <message>
        <source>Remove sound</source>
        <translation>Ton entfernen</translation>
    </message>
    <message>
        <source>The film has no sound then.</source>
        <translation>Der Film hat dann keinen Ton.</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>The part of the film that repeats, in seconds. A film that is exported as a loop shows it, and no picture twice.</source>
        <translation>Der Teil des Films, der sich wiederholt, in Sekunden. Ein Film, der als Schleife exportiert wird, zeigt ihn, und kein Bild doppelt.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Zyklus ändern</translation>
    </message>
    <message>
        <source>Choose Sound</source>
        <translation>Ton auswählen</translation>
    </message>
    <message>
        <source>Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</source>
        <translation>Ton und Filme (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</translation>
    </message>
</context>
<context>
    <name>wend::FlowPanel</name>
    <message>
        <source>Relax</source>
        <translation>Entspannen</translation>
    </message>
    <message>
        <source>The pins stay where they are, and what lies between them releases its tension. This takes one second at the end of the film.</source>
        <translation>Die Pins bleiben, wo sie sind, und was dazwischen liegt, lässt seine Spannung los. Das nimmt eine Sekunde am Ende des Films ein.</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Federt zurück</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>Noch hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>A shape that springs back fully is always relaxed.</source>
        <translation>Eine Form, die vollständig zurückfedert, ist immer entspannt.</translation>
    </message>
</context>
<context>
    <name>wend::GroupList</name>
    <message>
        <source>Hold It</source>
        <translation>Festhalten</translation>
    </message>
    <message>
        <source>Groups of the file</source>
        <translation>Gruppen der Datei</translation>
    </message>
    <message>
        <source>What the mesh&apos;s file calls by a name or number. A click marks a group on the shape; a double click, or Enter, pins it.</source>
        <translation>Was die Datei des Netzes mit einem Namen oder einer Nummer nennt. Ein Klick zeigt eine Gruppe auf der Form; ein Doppelklick oder die Eingabetaste macht einen Pin daraus.</translation>
    </message>
    <message>
        <source>Hold the group</source>
        <translation>Die Gruppe festhalten</translation>
    </message>
    <message>
        <source>Makes a pin of the chosen group, which the project names, so that it fits other meshes, too.</source>
        <translation>Macht aus der gewählten Gruppe einen Pin. Das Projekt nennt die Gruppe beim Namen, sodass er auch zu anderen Netzen passt.</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>Volumen</translation>
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
        <translation>Einen Pin wählen, um seine Zahlen zu sehen.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Bewegen um</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Skalieren mit</translation>
    </message>
    <message>
        <source>Exact step</source>
        <translation>Genauer Schritt</translation>
    </message>
    <message>
        <source>Moves, rotates or scales what is selected by exact numbers.</source>
        <translation>Bewegt, dreht oder skaliert das Gewählte um genaue Zahlen.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>How far along x, y and z; an angle; or a factor.</source>
        <translation>Wie weit in x, y und z; ein Winkel; oder ein Faktor.</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>um X</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>um Y</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>um Z</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The axis of the rotation, through the middle of what is selected.</source>
        <translation>Die Drehachse, durch die Mitte des Gewählten.</translation>
    </message>
    <message>
        <source>Applies this step; it becomes part of the motion.</source>
        <translation>Führt diesen Schritt aus; er wird Teil der Bewegung.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>at %1, %2, %3</source>
        <translation>bei %1, %2, %3</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>bei %1; %2</translation>
    </message>
    <message>
        <source>does not hold now</source>
        <translation>hält jetzt nicht</translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>wend::KeyPoseStrip</name>
    <message>
        <source>Key poses</source>
        <translation>Schlüsselposen</translation>
    </message>
    <message>
        <source>The shape at the key poses of all pins: a click goes there</source>
        <translation>Die Form in den Schlüsselposen aller Pins: Ein Klick geht dorthin</translation>
    </message>
    <message>
        <source>Key pose at %1</source>
        <translation>Schlüsselpose: %1</translation>
    </message>
</context>
<context>
    <name>wend::LanguageChoice</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Wie der &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>Speak the desktop&apos;s language, if Wend knows it</source>
        <translation>Die Sprache des Schreibtischs sprechen, wenn Wend sie kennt</translation>
    </message>
    <message>
        <source>Speak %1</source>
        <translation>%1 sprechen</translation>
    </message>
    <message>
        <source>The language of the window, from the next start of Wend</source>
        <translation>Die Sprache des Fensters, ab dem nächsten Start von Wend</translation>
    </message>
    <message>
        <source>The language changes when Wend starts the next time.</source>
        <translation>Die Sprache wechselt, wenn Wend das nächste Mal startet.</translation>
    </message>
</context>
<context>
    <name>wend::LayerPanel</name>
    <message>
        <source>The material is the same everywhere: brush over the shape to change a part.</source>
        <translation>Es ist überall gleich: Über die Form malen, um einen Teil zu ändern.</translation>
    </message>
    <message>
        <source>Each along a direction of its own.</source>
        <translation>Jede in ihrer eigenen Richtung.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Lets the chosen layer win over the one above it.</source>
        <translation>Lässt die gewählte Ebene vor der darüber gelten.</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Lets the layer below win over the chosen one.</source>
        <translation>Lässt die Ebene darunter vor der gewählten gelten.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Removes the chosen layer.</source>
        <translation>Entfernt die gewählte Ebene.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>How many times stiffer the layer is along its direction; ×1 is the same as everywhere.</source>
        <translation>Wievielmal steifer die Ebene in ihrer Richtung ist; ×1 ist wie überall.</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Steife Richtung</translation>
    </message>
    <message>
        <source>At rest; it turns with the shape. A change is for all regions of the layer.</source>
        <translation>In Ruhe; sie dreht sich mit der Form. Eine andere gilt für alle Bereiche der Ebene.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>How wide the edge fades, in the shape&apos;s own units.</source>
        <translation>Wie breit der Rand ausläuft, in den Einheiten der Form.</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>Weicher &amp;Rand</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Weichen Rand ändern</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>Ebene ändern</translation>
    </message>
    <message>
        <source>Unnamed</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>Where the material differs. The topmost layer wins; drag a layer to move it. A click shows its values, a double-click changes its name, its eye or the space bar switches it off.</source>
        <translation>Wo das Material ein anderes ist. Die oberste gewinnt: Ebenen lassen sich an ihren Platz ziehen. Ein Klick zeigt ihre Werte, ein Doppelklick ändert den Namen, das Auge oder die Leertaste schaltet sie aus.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Imports the material from pictures made in a paint program, and exports it as such.</source>
        <translation>Holt das Material aus Bildern eines Malprogramms und schreibt es als solche.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Takes the pictures as they are now, after they have been saved in a paint program.</source>
        <translation>Nimmt die Bilder, wie sie jetzt sind: nachdem sie in einem Malprogramm gespeichert wurden.</translation>
    </message>
    <message>
        <source>Read pictures again</source>
        <translation>Bilder neu lesen</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ebene ausblenden</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Ebene einblenden</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Erhalt: %1</translation>
    </message>
    <message>
        <source>Stiffness: %1</source>
        <translation>Steifigkeit: %1</translation>
    </message>
    <message>
        <source>Direction: %1</source>
        <translation>Richtung: %1</translation>
    </message>
    <message>
        <source>As the project&apos;s file says, cell by cell.</source>
        <translation>Wie es in der Projektdatei steht, Zelle für Zelle.</translation>
    </message>
    <message>
        <source>Cell by cell: %1</source>
        <translation>Zelle für Zelle: %1</translation>
    </message>
    <message>
        <source>Values of cells</source>
        <translation>Werte der Zellen</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>Nach unten &amp;vereinen</translation>
    </message>
    <message>
        <source>Makes one layer of the chosen one and the one below it</source>
        <translation>Macht aus der gewählten Ebene und der darunter eine</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>Ebenen vereinen</translation>
    </message>
    <message>
        <source>Stiffness ×1 has no direction: first choose how many times stiffer it is.</source>
        <translation>Steifigkeit ×1 hat keine Richtung: erst wählen, wievielmal steifer es ist.</translation>
    </message>
    <message>
        <source>What a file gives cell by cell stays lowest.</source>
        <translation>Was eine Datei von jeder Zelle sagt, bleibt zuunterst.</translation>
    </message>
    <message>
        <source>This is already the lowest layer.</source>
        <translation>Es ist schon die unterste Ebene.</translation>
    </message>
    <message>
        <source>This is already the topmost layer.</source>
        <translation>Es ist schon die oberste Ebene.</translation>
    </message>
    <message>
        <source>One of the two is switched off, is a picture, or erases.</source>
        <translation>Eine der beiden ist ausgeschaltet, ist ein Bild oder radiert.</translation>
    </message>
    <message>
        <source>There is no layer below it.</source>
        <translation>Unter ihr liegt keine Ebene.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Umbe&amp;nennen</translation>
    </message>
    <message>
        <source>What a file says of each cell has no name.</source>
        <translation>Was eine Datei über jede Zelle sagt, hat keinen Namen.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>Whether the layer changes Keep, and to what.</source>
        <translation>Ob die Ebene den Erhalt ändert, und wozu.</translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>Haupt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation>%1[*] – Wend</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Let go to open “%1”</source>
        <translation>Loslassen, um „%1“ zu öffnen</translation>
    </message>
    <message numerus="yes">
        <source>Let go to open %n pictures as parts</source>
        <translation>
            <numerusform>Loslassen, um %n Bild als Teil zu öffnen</numerusform>
            <numerusform>Loslassen, um %n Bilder als Teile zu öffnen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>The first page</source>
        <translation>Die erste Seite</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The previous page</source>
        <translation>Die Seite davor</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Das steht auf keiner Seite.</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Enter goes to the next place with these words, on this page or another.</source>
        <translation>Die Eingabetaste geht zur nächsten Stelle mit diesen Worten, auf dieser Seite oder einer anderen.</translation>
    </message>
</context>
<context>
    <name>wend::MaterialActions</name>
    <message>
        <source>A grey picture over the whole, as a layer: black keeps area, white keeps angles</source>
        <translation>Ein graues Bild über das Ganze, als Ebene: Schwarz erhält Flächen, Weiß Winkel</translation>
    </message>
    <message>
        <source>Import &amp;Stiffness…</source>
        <translation>&amp;Steifigkeit holen …</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer: black is the same as everywhere, white is 1000 times stiffer</source>
        <translation>Ein graues Bild über das Ganze, als Ebene: Schwarz ist wie überall, Weiß 1000-mal steifer</translation>
    </message>
    <message>
        <source>Import &amp;Directions…</source>
        <translation>&amp;Richtungen holen …</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer, of the direction of stiffness: black is level, middle grey upright</source>
        <translation>Ein graues Bild über das Ganze, als Ebene: Schwarz liegt, mittleres Grau steht, und was steif ist, ist es in dieser Richtung</translation>
    </message>
    <message>
        <source>Import Values of &amp;Cells…</source>
        <translation>Werte der &amp;Zellen holen …</translation>
    </message>
    <message>
        <source>φ and B of every cell from a mesh file that contains them, such as an exported one</source>
        <translation>φ und B jeder Zelle aus einer Netzdatei, die sie enthält, etwa einer exportierten</translation>
    </message>
    <message>
        <source>As a grey picture, to be edited in a paint program</source>
        <translation>Als graues Bild, zum Weitermalen in einem Malprogramm</translation>
    </message>
    <message>
        <source>Export S&amp;tiffness…</source>
        <translation>S&amp;teifigkeit schreiben …</translation>
    </message>
    <message>
        <source>Export Di&amp;rections…</source>
        <translation>R&amp;ichtungen schreiben …</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>&amp;Material</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Zuerst ein Bild öffnen.</translation>
    </message>
    <message>
        <source>For a solid, these are values of cells; they are exported with its mesh.</source>
        <translation>Bei einem Körper sind es Werte der Zellen; sie werden mit seinem Netz geschrieben.</translation>
    </message>
    <message>
        <source>Only the cells of a mesh file stay the same.</source>
        <translation>Nur die Zellen einer Netzdatei bleiben dieselben.</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 holen</translation>
    </message>
    <message>
        <source>Values of cells (*.vtu *.vtk *.json)</source>
        <translation>Werte der Zellen (*.vtu *.vtk *.json)</translation>
    </message>
    <message>
        <source>The layers were switched off: what was imported lies below them.</source>
        <translation>Die Ebenen sind ausgeschaltet: Was geholt wurde, steht unter ihnen.</translation>
    </message>
    <message>
        <source>Import &amp;Keep…</source>
        <translation>&amp;Erhalt importieren …</translation>
    </message>
    <message>
        <source>Export K&amp;eep…</source>
        <translation>E&amp;rhalt exportieren …</translation>
    </message>
</context>
<context>
    <name>wend::MaterialPanel</name>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>Between %1 and %2.</source>
        <translation>Zwischen %1 und %2.</translation>
    </message>
    <message>
        <source>Grown ×%1 – try %2</source>
        <translation>×%1 gewachsen – %2?</translation>
    </message>
    <message>
        <source>The shape has become much larger than at rest. A click keeps more of its size.</source>
        <translation>Die Form ist viel größer geworden als in Ruhe. Ein Klick erhält mehr von ihrer Größe.</translation>
    </message>
    <message>
        <source>Whole shape</source>
        <translation>Ganze Form</translation>
    </message>
    <message>
        <source>Keep: whole shape</source>
        <translation>Erhalt: ganze Form</translation>
    </message>
</context>
<context>
    <name>wend::MeasurePanel</name>
    <message>
        <source>Measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>Size of the solid</source>
        <translation>Größe des Körpers</translation>
    </message>
    <message>
        <source>Volume and area of the surface, now and at rest.</source>
        <translation>Volumen und Oberfläche, jetzt und in Ruhe.</translation>
    </message>
    <message>
        <source>Size of what is selected</source>
        <translation>Größe der Auswahl</translation>
    </message>
    <message>
        <source>Volume of the tetrahedra and area of the outer triangles that the selected handles hold.</source>
        <translation>Volumen der Tetraeder und Fläche der äußeren Dreiecke, die die gewählten Griffe halten.</translation>
    </message>
    <message>
        <source>Vertex under the pointer</source>
        <translation>Punkt unter dem Zeiger</translation>
    </message>
    <message>
        <source>The nearest vertex and where it is.</source>
        <translation>Der nächste Netzpunkt und wo er ist.</translation>
    </message>
    <message>
        <source>Tetrahedron under the pointer</source>
        <translation>Tetraeder unter dem Zeiger</translation>
    </message>
    <message>
        <source>All values of the tetrahedron.</source>
        <translation>Alle Werte des Tetraeders.</translation>
    </message>
    <message>
        <source>%1, at rest %2</source>
        <translation>%1, in Ruhe %2</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>The whole</source>
        <translation>Das Ganze</translation>
    </message>
    <message numerus="yes">
        <source>Selected vertices: %n</source>
        <translation>
            <numerusform>Ausgewählt: %n Punkt</numerusform>
            <numerusform>Ausgewählt: %n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Point at the solid to see the values there.</source>
        <translation>Auf den Körper zeigen, um die Werte dort zu sehen.</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>pointed at</source>
        <translation>gezeigt auf</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Tetrahedron %1</source>
        <translation>Tetraeder %1</translation>
    </message>
    <message>
        <source>dihedral angles</source>
        <translation>Winkel zwischen Seiten</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>circumradius to shortest edge</source>
        <translation>Umkreisradius zu kürzester Kante</translation>
    </message>
</context>
<context>
    <name>wend::MemorySlider</name>
    <message>
        <source>not at all</source>
        <translation>gar nicht</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>ganz</translation>
    </message>
</context>
<context>
    <name>wend::MeshPanel</name>
    <message>
        <source>Vertices</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Das Netz kommt aus einer Datei und wird verwendet, wie es ist.</translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation>Dieses Bild hat keine Transparenz.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation>%1 Punkte, %2 Dreiecke</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 Punkte, %2 Tetraeder</translation>
    </message>
    <message>
        <source>Maximum volume</source>
        <translation>Größtes Volumen</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>What sets how fine the mesh is: how many vertices it has in total, or how large a tetrahedron may be.</source>
        <translation>Was sagt, wie fein das Netz ist: wie viele Punkte es im Ganzen hat, oder wie groß ein Tetraeder sein darf.</translation>
    </message>
    <message>
        <source>A&amp;im at</source>
        <translation>Z&amp;iel</translation>
    </message>
    <message>
        <source>Aim at a volume</source>
        <translation>Volumen als Ziel</translation>
    </message>
    <message>
        <source>Aim at vertices</source>
        <translation>Zahl der Punkte als Ziel</translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Malen …</translation>
    </message>
    <message>
        <source>Cell sizes</source>
        <translation>Zellgrößen</translation>
    </message>
    <message>
        <source>Paints where the mesh should be finer or coarser, or sets it by regions in numbers.</source>
        <translation>Malt, wo das Netz feiner oder gröber sein soll, oder sagt es durch Gebiete in Zahlen.</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Feiner und gröber</translation>
    </message>
    <message>
        <source>Detail: coarse – fine</source>
        <translation>Feinheit: grob – fein</translation>
    </message>
    <message>
        <source>No outline has been drawn.</source>
        <translation>Es ist kein Umriss gezeichnet.</translation>
    </message>
    <message>
        <source>Outline and detail of</source>
        <translation>Umriss und Detail von</translation>
    </message>
    <message>
        <source>Which part of the picture has the outline and detail below; all have the same unless one has its own. Choosing a part in the list of parts chooses it here.</source>
        <translation>Welcher Teil des Bildes den Umriss und das Detail darunter hat; alle haben dieselben, wenn einer keine eigenen hat. Ein Teil, der in der Liste der Teile gewählt wird, ist es auch hier.</translation>
    </message>
    <message>
        <source>As All Parts</source>
        <translation>Wie alle Teile</translation>
    </message>
    <message>
        <source>Gives this part the outline and detail of all parts again.</source>
        <translation>Gibt diesem Teil wieder den Umriss und das Detail aller Teile.</translation>
    </message>
    <message>
        <source>&amp;Of</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Alle Teile</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view shows it, and surface formats contain it.</source>
        <translation>Nimmt eine feine, vielleicht texturierte Oberfläche aus einer Datei: Sie reitet im Körper mit, die Ansicht zeigt sie, und Flächenformate erhalten sie.</translation>
    </message>
    <message>
        <source>Shows and exports the solid with its own surface again.</source>
        <translation>Der Körper wird wieder mit seiner eigenen Oberfläche gezeigt und exportiert.</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Haut wählen</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Haut entfernen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
</context>
<context>
    <name>wend::ModeRow</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the picture is shown; a click shows its pixels as they are.</source>
        <translation>Wie groß das Bild zu sehen ist; ein Klick zeigt seine Pixel, wie sie sind.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Export what is shown as a picture, film, sequence, ST map, mesh or view</source>
        <translation>Schreiben, was zu sehen ist: als Bild, Film, Sequenz, ST-Map, Netz oder Ansicht</translation>
    </message>
</context>
<context>
    <name>wend::MotionChooser</name>
    <message>
        <source>Apply Motion of Another Project</source>
        <translation>Bewegung eines anderen Projekts übernehmen</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Projekte (*.wend)</translation>
    </message>
    <message>
        <source>This motion cannot be applied. %1</source>
        <translation>Diese Bewegung kann nicht übernommen werden. %1</translation>
    </message>
    <message>
        <source>Apply motion of %1</source>
        <translation>Bewegung von %1 übernehmen</translation>
    </message>
</context>
<context>
    <name>wend::Offers</name>
    <message>
        <source>This picture fills its frame. If its border is held, it bends inside and no gap opens at the edges.</source>
        <translation>Dieses Bild füllt seinen Rahmen. Mit festgehaltenem Rand biegt es sich im Inneren, und an den Kanten entsteht keine Lücke.</translation>
    </message>
    <message>
        <source>Hold the Border</source>
        <translation>Bildrand festhalten</translation>
    </message>
    <message>
        <source>Soft edges or shadows of this picture reach beyond the cut-out, and are cut off.</source>
        <translation>Weiche Kanten oder Schatten dieses Bildes reichen über den Ausschnitt hinaus und werden abgeschnitten.</translation>
    </message>
    <message>
        <source>Include Them</source>
        <translation>Mitnehmen</translation>
    </message>
    <message>
        <source>This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they enclose, too.</source>
        <translation>Dieses Bild besteht vor allem aus dünnen Linien, und nur die Linien würden sich biegen. Mit gefüllten Löchern biegt sich auch, was sie umschließen.</translation>
    </message>
    <message>
        <source>Fill the Holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n Bild wurde als Teil geöffnet: es biegt sich für sich.</numerusform>
            <numerusform>%n Bilder wurden als Teile geöffnet: jeder biegt sich für sich. Verbinden Sie sie unter Teile, wo sie sich treffen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layers were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n Ebene wurde als Teil geöffnet: sie biegt sich für sich.</numerusform>
            <numerusform>%n Ebenen wurden als Teile geöffnet: jeder biegt sich für sich. Verbinden Sie sie unter Teile, wo sie sich treffen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open Flattened</source>
        <translation>Reduziert öffnen</translation>
    </message>
    <message>
        <source>Open flattened</source>
        <translation>Reduziert öffnen</translation>
    </message>
    <message>
        <source>Another Size…</source>
        <translation>Andere Größe …</translation>
    </message>
    <message>
        <source>This drawing became a picture of %1 × %2 pixels.</source>
        <translation>Diese Zeichnung wurde ein Bild von %1 × %2 Pixeln.</translation>
    </message>
</context>
<context>
    <name>wend::OpeningNote</name>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
</context>
<context>
    <name>wend::OptionRow</name>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
</context>
<context>
    <name>wend::PaintPanel</name>
    <message>
        <source>along X</source>
        <translation>entlang X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>entlang Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>entlang Z</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Steife Richtung</translation>
    </message>
    <message>
        <source>St&amp;iffness</source>
        <translation>St&amp;eifigkeit</translation>
    </message>
    <message>
        <source>as numbers</source>
        <translation>als Zahlen</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>längs des Blicks</translation>
    </message>
    <message>
        <source>along the stroke</source>
        <translation>längs des Strichs</translation>
    </message>
    <message>
        <source>along the pin&apos;s path</source>
        <translation>längs des Pin-Wegs</translation>
    </message>
    <message>
        <source>Direction in numbers</source>
        <translation>Richtung in Zahlen</translation>
    </message>
    <message>
        <source>How many times stiffer the painted part is along its direction; ×1 is the same as everywhere.</source>
        <translation>Wievielmal steifer der gemalte Teil in seiner Richtung ist; ×1 ist wie überall.</translation>
    </message>
    <message>
        <source>The direction at rest, which turns with the shape: the stroke&apos;s own, the one that is there, an axis, numbers, or the path of the selected pin where it is nearest.</source>
        <translation>Die Richtung in Ruhe, die sich mit der Form dreht: die des Strichs, die schon da ist, eine Achse, Zahlen oder der Weg des gewählten Pins, wo er am nächsten ist.</translation>
    </message>
    <message>
        <source>At rest; its length does not matter.</source>
        <translation>In Ruhe; die Länge ist gleichgültig.</translation>
    </message>
    <message>
        <source>Di&amp;rection</source>
        <translation>Richt&amp;ung</translation>
    </message>
    <message>
        <source>as it is there</source>
        <translation>wie es dort ist</translation>
    </message>
    <message>
        <source>What the brush paints</source>
        <translation>Was der Pinsel malt</translation>
    </message>
    <message>
        <source>The brush paints</source>
        <translation>Der Pinsel malt</translation>
    </message>
</context>
<context>
    <name>wend::PartList</name>
    <message>
        <source>Joint x</source>
        <translation>Gelenk x</translation>
    </message>
    <message>
        <source>Joint y</source>
        <translation>Gelenk y</translation>
    </message>
    <message>
        <source>Move joint</source>
        <translation>Gelenk verschieben</translation>
    </message>
    <message>
        <source>Where the part turns at rest, in pixels from the upper left corner: a point in both parts, marked by a ring on the picture.</source>
        <translation>Wo sich der Teil in der Ruhelage dreht, in Pixeln von der linken oberen Ecke: ein Punkt in beiden Teilen, im Bild mit einem Ring markiert.</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>rides on %1</source>
        <translation>folgt %1</translation>
    </message>
    <message>
        <source>joined to %1</source>
        <translation>verbunden mit %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Opac&amp;ity</source>
        <translation>Deck&amp;kraft</translation>
    </message>
    <message>
        <source>&amp;Joined to</source>
        <translation>Ver&amp;bunden mit</translation>
    </message>
    <message>
        <source>&amp;Rides on</source>
        <translation>&amp;Folgt</translation>
    </message>
    <message>
        <source>Parts of the picture</source>
        <translation>Teile des Bildes</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Nach vorn</translation>
    </message>
    <message>
        <source>Brings the part in front of the next one (Alt+Up).</source>
        <translation>Bringt den Teil vor den nächsten (Alt+Aufwärts).</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>Nach hinten</translation>
    </message>
    <message>
        <source>Brings the part behind the next one (Alt+Down).</source>
        <translation>Bringt den Teil hinter den nächsten (Alt+Abwärts).</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How much is seen of the part.</source>
        <translation>Wie stark der Teil zu sehen ist.</translation>
    </message>
    <message>
        <source>Joined to</source>
        <translation>Verbunden mit</translation>
    </message>
    <message>
        <source>Welds the part to another one in the middle of where they overlap at rest: it turns there, and pulls nothing else.</source>
        <translation>Verbindet den Teil mit einem anderen in der Mitte ihrer Überlappung in Ruhe: dort dreht er sich und zieht sonst nichts mit.</translation>
    </message>
    <message>
        <source>Rides on</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>The part follows the motion of another one, as eyes do on a face.</source>
        <translation>Der Teil folgt der Bewegung eines anderen, wie Augen in einem Gesicht.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>Choose a part that is not in front.</source>
        <translation>Wählen Sie einen Teil, der nicht ganz vorn ist.</translation>
    </message>
    <message>
        <source>Choose a part that is not at the back.</source>
        <translation>Wählen Sie einen Teil, der nicht ganz hinten ist.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Teil verbergen</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Another part has this name.</source>
        <translation>Ein anderer Teil hat diesen Namen.</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>Teil umbenennen</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Reihenfolge ändern</translation>
    </message>
    <message>
        <source>These parts do not overlap at rest: there is no place for a joint.</source>
        <translation>Diese Teile überlappen in Ruhe nicht: für ein Gelenk ist kein Platz.</translation>
    </message>
    <message>
        <source>Remove joint</source>
        <translation>Gelenk entfernen</translation>
    </message>
    <message>
        <source>Join parts</source>
        <translation>Teile verbinden</translation>
    </message>
    <message>
        <source>Change what a part rides on</source>
        <translation>Ändern, wem ein Teil folgt</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Multiplizieren</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Negativ multiplizieren</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addieren</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>&amp;Blend mode</source>
        <translation>&amp;Mischmodus</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mischmodus</translation>
    </message>
    <message>
        <source>How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen and Add lighten, as light does.</source>
        <translation>Wie der Teil mit dem verrechnet wird, was unter ihm liegt: Multiplizieren dunkelt ab, wie ein Schatten; Negativ multiplizieren und Addieren hellen auf, wie Licht.</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Mischmodus ändern</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>&amp;Weicher Rand</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>How wide the edge is along which the part was cut out. The colours of what is behind it are removed from it.</source>
        <translation>Wie breit der Rand ist, an dem der Teil ausgeschnitten wurde. Die Farben dessen, was dahinter ist, werden aus ihm entfernt.</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Weichen Rand ändern</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies in front; click its eye to hide it; the lock at its end protects it from changes; a double-click changes its name.</source>
        <translation>Der vorderste Teil steht oben. Ziehen Sie einen Teil, oder drücken Sie Alt mit den Pfeiltasten, um die Reihenfolge zu ändern; ein Klick auf sein Auge verbirgt ihn; das Schloss am Ende schützt ihn vor Änderungen; ein Doppelklick ändert den Namen.</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>The part is seen, but clicks go through it, and it is neither painted nor are its pins moved.</source>
        <translation>Der Teil ist zu sehen, aber Klicks gehen durch ihn hindurch; er wird nicht bemalt, und seine Pins bewegen sich nicht.</translation>
    </message>
    <message>
        <source>Choose a part.</source>
        <translation>Wählen Sie einen Teil.</translation>
    </message>
    <message>
        <source>Lock part</source>
        <translation>Teil sperren</translation>
    </message>
    <message>
        <source>Unlock part</source>
        <translation>Teil entsperren</translation>
    </message>
</context>
<context>
    <name>wend::PartOrderRow</name>
    <message>
        <source>In Front from Here</source>
        <translation>Ab hier vorn</translation>
    </message>
    <message>
        <source>From the shown time on the part is in front of all others; before, it stays where it is.</source>
        <translation>Von der gezeigten Zeit an ist der Teil vor allen anderen; vorher bleibt er, wo er ist.</translation>
    </message>
    <message>
        <source>Behind from Here</source>
        <translation>Ab hier hinten</translation>
    </message>
    <message>
        <source>From the shown time on the part is behind all others; before, it stays where it is.</source>
        <translation>Von der gezeigten Zeit an ist der Teil hinter allen anderen; vorher bleibt er, wo er ist.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Removes all changes of the order of this part.</source>
        <translation>Entfernt alle Änderungen der Reihenfolge dieses Teils.</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>Reihenfolge beibehalten</translation>
    </message>
    <message>
        <source>In front from here on</source>
        <translation>Von hier an vorn</translation>
    </message>
    <message>
        <source>Behind from here on</source>
        <translation>Von hier an hinten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Changes at %1</source>
        <translation>Ändert sich bei %1</translation>
    </message>
</context>
<context>
    <name>wend::PictureActions</name>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>What you draw will bend, too; Ctrl takes it away instead</source>
        <translation>Was gezeichnet wird, soll sich auch biegen; mit Strg wird es weggenommen</translation>
    </message>
    <message>
        <source>&amp;Take Away</source>
        <translation>&amp;Wegnehmen</translation>
    </message>
    <message>
        <source>What you draw will not bend; Ctrl adds it instead</source>
        <translation>Was gezeichnet wird, soll sich nicht biegen; mit Strg kommt es hinzu</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen; also [ and ]</source>
        <translation>Wie breit der Pinsel ist, auf dem Bildschirm; auch [ und ]</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much colours may differ; this also changes the last click. Also [ and ]</source>
        <translation>Wie weit Farben auseinander liegen dürfen, auch für den letzten Klick; auch [ und ]</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>&amp;Teil machen</translation>
    </message>
    <message>
        <source>What you draw becomes a part that bends by itself; what is behind it is filled</source>
        <translation>Was Sie zeichnen, wird ein Teil, das sich allein biegt; was dahinter liegt, wird gefüllt</translation>
    </message>
</context>
<context>
    <name>wend::PictureDialog</name>
    <message>
        <source>%1 has no transparency: the background is that of the view.</source>
        <translation>%1 kennt keine Transparenz: Der Hintergrund ist der der Ansicht.</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Breite des Bildes in Pixeln.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the picture in pixels; it decides how large the solid is.</source>
        <translation>Höhe des Bildes in Pixeln; sie bestimmt, wie groß der Körper ist.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Only the solid, without a background.</source>
        <translation>Nur der Körper, ohne Grund.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>Pins and axes</source>
        <translation>Pins und Achsen</translation>
    </message>
    <message>
        <source>Pins, their paths and the axes, as large as in the window.</source>
        <translation>Pins, ihre Wege und die Achsen, so groß wie im Fenster.</translation>
    </message>
    <message>
        <source>&amp;Proportions of the view</source>
        <translation>&amp;Seitenverhältnis der Ansicht</translation>
    </message>
    <message>
        <source>P&amp;ins and axes</source>
        <translation>P&amp;ins und Achsen</translation>
    </message>
    <message>
        <source>Proportions of the view</source>
        <translation>Seitenverhältnis der Ansicht</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the view shows.</source>
        <translation>Breite und Höhe folgen einander, sodass das Bild zeigt, was die Ansicht zeigt.</translation>
    </message>
    <message>
        <source>Width and height must be between %1 and %2 pixels.</source>
        <translation>Breite und Höhe müssen zwischen %1 und %2 Pixeln liegen.</translation>
    </message>
    <message>
        <source>Export View</source>
        <translation>Ansicht exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>Welche Art von Datei geschrieben wird.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormat</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>&amp;Legend of the overlay</source>
        <translation>&amp;Legende der Überlagerung</translation>
    </message>
    <message>
        <source>Legend of the overlay</source>
        <translation>Legende der Überlagerung</translation>
    </message>
    <message>
        <source>The colours of the overlay and their values.</source>
        <translation>Die Farben der Überlagerung und ihre Werte.</translation>
    </message>
    <message>
        <source>Show the colour overlay first: it has the legend.</source>
        <translation>Erst die Farbüberlagerung zeigen: Zu ihr gehört die Legende.</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Film exportieren</translation>
    </message>
</context>
<context>
    <name>wend::PictureKeeper</name>
    <message>
        <source>The picture “%1” was changed by another program.</source>
        <translation>Das Bild „%1“ wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Reload picture</source>
        <translation>Bild neu laden</translation>
    </message>
    <message>
        <source>Replace Picture</source>
        <translation>Bild ersetzen</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Replace picture</source>
        <translation>Bild ersetzen</translation>
    </message>
    <message>
        <source>The picture cannot be read. %1</source>
        <translation>Das Bild kann nicht gelesen werden. %1</translation>
    </message>
    <message>
        <source>It has %1 × %2 pixels, and the picture before had %3 × %4.</source>
        <translation>Es hat %1 × %2 Pixel, und das Bild davor hatte %3 × %4.</translation>
    </message>
    <message>
        <source>This picture has other proportions. %1</source>
        <translation>Dieses Bild hat andere Proportionen. %1</translation>
    </message>
    <message>
        <source>The picture has other proportions now. %1</source>
        <translation>Das Bild hat jetzt andere Proportionen. %1</translation>
    </message>
    <message>
        <source>Pins and paths are scaled with it. %1</source>
        <translation>Pins und Wege sind mit ihm angepasst. %1</translation>
    </message>
    <message>
        <source>Change drawing size</source>
        <translation>Größe der Zeichnung ändern</translation>
    </message>
</context>
<context>
    <name>wend::PinActions</name>
    <message>
        <source>&amp;Pins</source>
        <translation>&amp;Pins</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>The selected pins are neither moved nor removed until unlocked</source>
        <translation>Die gewählten Pins werden weder bewegt noch entfernt, bis sie entsperrt sind</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Verbergen</translation>
    </message>
    <message>
        <source>The selected pins still hold, but are neither drawn nor picked</source>
        <translation>Die gewählten Pins halten weiter, werden aber weder gezeichnet noch getroffen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>Alle &amp;zeigen</translation>
    </message>
    <message>
        <source>Show all hidden pins again</source>
        <translation>Alle verborgenen Pins wieder zeigen</translation>
    </message>
    <message>
        <source>Alt+Shift+H</source>
        <translation>Alt+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Group…</source>
        <translation>&amp;Gruppieren …</translation>
    </message>
    <message>
        <source>Put the selected pins under a heading of the list</source>
        <translation>Die gewählten Pins in der Liste unter eine Überschrift stellen</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Gruppierung &amp;aufheben</translation>
    </message>
    <message>
        <source>Take the selected pins out of their groups</source>
        <translation>Die gewählten Pins aus ihren Gruppen nehmen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Lin&amp;k</source>
        <translation>Ver&amp;knüpfen</translation>
    </message>
    <message>
        <source>The selected pins move together, whichever of them is dragged</source>
        <translation>Die gewählten Pins bewegen sich zusammen, gleich welcher von ihnen gezogen wird</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>S&amp;piegeln</translation>
    </message>
    <message>
        <source>Set pins at the mirror images of the selected ones, across the middle of the shape, with mirrored motions</source>
        <translation>Pins dorthin setzen, wo die gewählten in einem Spiegel durch die Mitte der Form liegen, mit gespiegelten Bewegungen</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Mirror M&amp;otion</source>
        <translation>Be&amp;wegung spiegeln</translation>
    </message>
    <message>
        <source>The selected pins move to the other side instead</source>
        <translation>Die gewählten Pins bewegen sich stattdessen zur anderen Seite</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>Braun</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>Türkis</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>Pflaume</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>By &amp;Place in the List</source>
        <translation>Nach dem &amp;Platz in der Liste</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>&amp;Andere …</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Zuerst einen Pin wählen.</translation>
    </message>
    <message>
        <source>The selected pin is in no group.</source>
        <translation>Der gewählte Pin ist in keiner Gruppe.</translation>
    </message>
    <message>
        <source>Select several pins first.</source>
        <translation>Zuerst mehrere Pins wählen.</translation>
    </message>
    <message>
        <source>Select a pin that moves.</source>
        <translation>Einen Pin wählen, der sich bewegt.</translation>
    </message>
    <message>
        <source>No pin is hidden.</source>
        <translation>Kein Pin ist verborgen.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Name of the group:</source>
        <translation>Name der Gruppe:</translation>
    </message>
    <message>
        <source>Colour of the Pin</source>
        <translation>Farbe des Pins</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Mo&amp;ve</source>
        <translation>Be&amp;wegen</translation>
    </message>
    <message>
        <source>Drag pins to move them; in a solid, also by the arrows</source>
        <translation>Pins ziehen bewegt sie; bei einem Körper auch seine Pfeile</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>Drag to rotate the selected pins; in a solid, by the rings</source>
        <translation>Ziehen dreht die gewählten Pins; bei einem Körper an seinen Ringen</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>S&amp;kalieren</translation>
    </message>
    <message>
        <source>Drag to scale the selected pins; in a solid, by the ring</source>
        <translation>Ziehen skaliert die gewählten Pins; bei einem Körper an seinem Ring</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Zuerst ein Bild öffnen.</translation>
    </message>
    <message>
        <source>Select &amp;Pins</source>
        <translation>&amp;Pins auswählen</translation>
    </message>
    <message>
        <source>What the pin tool and the select tool draw around pins to select them</source>
        <translation>Was mit dem Pin- oder Auswahlwerkzeug neben Pins gezogen wird, um sie auszuwählen</translation>
    </message>
    <message>
        <source>By &amp;Rectangle</source>
        <translation>Mit &amp;Rechteck</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>By &amp;Lasso</source>
        <translation>Mit &amp;Lasso</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>By &amp;Brush</source>
        <translation>Mit &amp;Pinsel</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Ei&amp;nrasten</translation>
    </message>
    <message>
        <source>New pins sit on corners of the mesh instead of where you click</source>
        <translation>Neue Pins sitzen auf Ecken des Netzes statt dort, wohin man klickt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ].</source>
        <translation>Der Durchmesser des Pinsels auf dem Bildschirm; auch mit den Tasten [ und ].</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pin for the Whole &amp;Animation</source>
        <translation>Für die ganze &amp;Animation halten</translation>
    </message>
    <message>
        <source>The selected pins hold from the start of the animation to its end, not only from the time at which they were set</source>
        <translation>Die gewählten Pins halten vom Anfang der Animation bis zu ihrem Ende, nicht erst ab der Zeit, zu der sie gesetzt wurden</translation>
    </message>
    <message>
        <source>The selected pin already holds for the whole animation.</source>
        <translation>Der gewählte Pin hält schon die ganze Animation lang.</translation>
    </message>
</context>
<context>
    <name>wend::PinList</name>
    <message>
        <source>Pins</source>
        <translation>Pins</translation>
    </message>
    <message>
        <source>Does not hold at the time shown.</source>
        <translation>Hält zur gezeigten Zeit nicht.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow keys move them. The eye hides, the lock protects from changes; a right-click groups, links and mirrors.</source>
        <translation>Hier Pins wählen; F2 benennt um, Entf entfernt, Eingabe geht zum Bild, wo die Pfeiltasten sie bewegen. Das Auge verbirgt, das Schloss schützt vor Änderungen; ein Rechtsklick gruppiert, verknüpft und spiegelt.</translation>
    </message>
    <message>
        <source>Moves together with others</source>
        <translation>Bewegt sich mit anderen zusammen</translation>
    </message>
    <message>
        <source>Hidden: a click shows it</source>
        <translation>Verborgen: Ein Klick zeigt ihn</translation>
    </message>
    <message>
        <source>A click hides it</source>
        <translation>Ein Klick verbirgt ihn</translation>
    </message>
    <message>
        <source>Locked: a click unlocks it</source>
        <translation>Gesperrt: Ein Klick entsperrt ihn</translation>
    </message>
    <message>
        <source>A click locks it</source>
        <translation>Ein Klick sperrt ihn</translation>
    </message>
    <message>
        <source>No pins yet</source>
        <translation>Noch keine Pins</translation>
    </message>
</context>
<context>
    <name>wend::ProblemRemedies</name>
    <message>
        <source>Use Multigrid</source>
        <translation>Mehrgitter verwenden</translation>
    </message>
    <message>
        <source>Half as Many Vertices</source>
        <translation>Halb so viele Punkte</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>wend::Properties</name>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>The same in numbers, for those who want them.</source>
        <translation>Dasselbe in Zahlen, für alle, die sie wollen.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pins</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Angaben</translation>
    </message>
    <message>
        <source>Size, area, volume and edges, the quality of the cells, and gaps that a cage closes.</source>
        <translation>Größe, Fläche, Volumen und Kanten, die Güte der Zellen und Spalte, die ein Käfig schließt.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
</context>
<context>
    <name>wend::PropertiesRail</name>
    <message>
        <source>Opens this part of the properties over the view; Esc closes it.</source>
        <translation>Öffnet diesen Teil der Eigenschaften über der Ansicht; Esc schließt ihn.</translation>
    </message>
</context>
<context>
    <name>wend::ReachRow</name>
    <message>
        <source>Pull reaches</source>
        <translation>Zug reicht</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads. Near: close to the pin, sharp. Far: soft and wide.</source>
        <translation>Wie weit sich der Zug eines Pins verteilt. Nah: dicht am Pin, scharf. Weit: weich und breit.</translation>
    </message>
    <message>
        <source>Pull &amp;reaches</source>
        <translation>Zug rei&amp;cht</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
    <message>
        <source>far</source>
        <translation>weit</translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Dieses Projekt glättet wie im Aufsatz mit λ; seine Datei sagt, wie viel.</translation>
    </message>
</context>
<context>
    <name>wend::RegionList</name>
    <message>
        <source>The mesh is equally fine everywhere: brush over what should be finer or coarser.</source>
        <translation>Das Netz ist überall gleich fein: überstreichen, was feiner oder gröber sein soll.</translation>
    </message>
    <message>
        <source>Nothing has an order of its own: brush over what should lie in front or behind.</source>
        <translation>Nichts hat eine eigene Ordnung: überstreichen, was vorn oder hinten liegen soll.</translation>
    </message>
    <message>
        <source>Where the mesh is finer or coarser</source>
        <translation>Wo das Netz feiner oder gröber ist</translation>
    </message>
    <message>
        <source>What lies in front</source>
        <translation>Was vorn liegt</translation>
    </message>
    <message>
        <source>The strokes and regions so far; where two overlap, the upper one counts. A click shows where it lies and its number, a double-click changes its name.</source>
        <translation>Die Striche und Gebiete, die es gibt; von zweien an einem Ort gilt das obere. Ein Klick zeigt, wo es liegt, und seine Zahl, ein Doppelklick ändert den Namen.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>Kantenlänge</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>How long edges are there, compared with elsewhere: less is finer, more is coarser.</source>
        <translation>Wie lang Kanten dort sind, gegen anderswo: weniger ist feiner, mehr ist gröber.</translation>
    </message>
    <message>
        <source>Greater than 0 lies in front, less than 0 behind.</source>
        <translation>Größer als 0 liegt vorn, kleiner hinten.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen region.</source>
        <translation>Nimmt das gewählte Gebiet weg.</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Feiner und gröber</translation>
    </message>
    <message>
        <source>In front and behind</source>
        <translation>Vorn und hinten</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>O&amp;rder</source>
        <translation>&amp;Ordnung</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Kanten ändern</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Ordnung ändern</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>Gebiet entfernen</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Eine Seite</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Gebiet umbenennen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Gebiet hinzufügen</translation>
    </message>
    <message>
        <source>A ball, a box or a half-space in the middle, or what the selected handle holds as a region; its numbers can then be changed.</source>
        <translation>Eine Kugel, ein Quader oder ein Halbraum in der Mitte, oder das Gebiet, das der gewählte Griff hält; die Zahlen lassen sich dann ändern.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Over what width the size blends into that around it, in the file&apos;s units.</source>
        <translation>Über welche Breite die Größe in die ringsum übergeht, in Einheiten der Datei.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Halbraum</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Region of the selected handle</source>
        <translation>Gebiet des gewählten Griffs</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>Weicher &amp;Rand</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Gebiet ändern</translation>
    </message>
    <message>
        <source>Add size region</source>
        <translation>Größengebiet hinzufügen</translation>
    </message>
    <message>
        <source>First select a pin that holds a ball, a box or one side.</source>
        <translation>Zuerst einen Pin auswählen, der eine Kugel, einen Quader oder eine Seite hält.</translation>
    </message>
    <message>
        <source>Beneath them: the factors in %1.</source>
        <translation>Darunter: die Faktoren in %1.</translation>
    </message>
    <message>
        <source>The surface&apos;s triangles are kept, and only the inside changes. “Refine surface” in the panel “Mesh” allows them to be split, too.</source>
        <translation>Die Dreiecke der Oberfläche bleiben, und nur das Innere ändert sich. „Oberfläche verfeinern“ im Feld „Netz“ lässt auch sie teilen.</translation>
    </message>
</context>
<context>
    <name>wend::RegionNumbers</name>
    <message>
        <source>Numbers of the region</source>
        <translation>Zahlen des Gebiets</translation>
    </message>
    <message>
        <source>As x, y and z, in the coordinates of the rest shape.</source>
        <translation>Als x, y und z, in den Koordinaten der Ruheform.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Halbraum</translation>
    </message>
    <message>
        <source>Kind of region</source>
        <translation>Art des Gebiets</translation>
    </message>
    <message>
        <source>What the region is; another kind keeps its place.</source>
        <translation>Was das Gebiet ist; eine andere Art behält seinen Ort.</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>&amp;Gebiet</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>point of the plane</source>
        <translation>Punkt der Ebene</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>direction into it</source>
        <translation>Richtung hinein</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>The radius of the ball.</source>
        <translation>Der Radius der Kugel.</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Ra&amp;dius</translation>
    </message>
</context>
<context>
    <name>wend::RegionPanel</name>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>There is no vertex in this region: nothing was changed.</source>
        <translation>In diesem Gebiet liegt kein Punkt: nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Gebiet ändern</translation>
    </message>
    <message numerus="yes">
        <source>Vertices: %n</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Ra&amp;dius</translation>
    </message>
    <message>
        <source>Holds its a&amp;ngle</source>
        <translation>&amp;Hält seinen Winkel</translation>
    </message>
    <message>
        <source>How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. In the shape&apos;s own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does the same.</source>
        <translation>Wie weit der Pin die Form um sich hält: 0 hält einen Punkt, mehr einen Kreis, in einem Körper eine Kugel. In der Einheit der Form, bei einem Bild in dessen Pixeln. Den Pin mit Strg und Umschalt zu ziehen bewirkt dasselbe.</translation>
    </message>
    <message>
        <source>The pin keeps the angle that the picture has there now, as a small circle; without it, the picture turns freely around the pin.</source>
        <translation>Der Pin behält als kleiner Kreis den Winkel, den das Bild dort jetzt hat; ohne das dreht sich das Bild frei um den Pin.</translation>
    </message>
</context>
<context>
    <name>wend::RidingOffer</name>
    <message>
        <source>A part has no pin and stays behind: let it ride on “%1”?</source>
        <translation>Ein Teil hat keinen Pin und bleibt zurück: Soll er „%1“ folgen?</translation>
    </message>
    <message>
        <source>A part has no pin and stays behind: let it ride on what is beside it?</source>
        <translation>Ein Teil hat keinen Pin und bleibt zurück: Soll er dem folgen, was neben ihm ist?</translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on “%1”?</source>
        <translation>
            <numerusform>%n Teil hat keinen Pin und bleibt zurück: Soll er „%1“ folgen?</numerusform>
            <numerusform>%n Teile haben keinen Pin und bleiben zurück: Sollen sie „%1“ folgen?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on what is beside them?</source>
        <translation>
            <numerusform>%n Teil hat keinen Pin und bleibt zurück: Soll er dem folgen, was neben ihm ist?</numerusform>
            <numerusform>%n Teile haben keinen Pin und bleiben zurück: Sollen sie dem folgen, was neben ihnen ist?</numerusform>
        </translation>
    </message>
    <message>
        <source>Let parts ride</source>
        <translation>Teile folgen lassen</translation>
    </message>
    <message>
        <source>Let It Ride</source>
        <translation>Folgen lassen</translation>
    </message>
    <message>
        <source>Let Them Ride</source>
        <translation>Folgen lassen</translation>
    </message>
</context>
<context>
    <name>wend::ShapeCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>Leinwand</translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation>Das Bild mit seinen Pins</translation>
    </message>
</context>
<context>
    <name>wend::ShapeNotices</name>
    <message>
        <source>“Refine surface” in the panel “Mesh” allows the surface&apos;s triangles to be split.</source>
        <translation>„Oberfläche verfeinern“ im Feld „Netz“ lässt die Dreiecke der Oberfläche teilen.</translation>
    </message>
    <message>
        <source>Pin It</source>
        <translation>Mit Pin halten</translation>
    </message>
    <message>
        <source>A part is joined to the rest at a single point, and may swing around it unless a pin holds it.</source>
        <translation>Ein Teil hängt nur an einem Punkt am Rest und kann um ihn schwingen, wenn kein Pin ihn hält.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts are joined to the rest at single points, and may swing around them unless pins hold them.</source>
        <translation>
            <numerusform>%n Teil hängt nur an einem Punkt am Rest und kann um ihn schwingen, wenn kein Pin ihn hält.</numerusform>
            <numerusform>%n Teile hängen nur an Punkten am Rest und können um sie schwingen, wenn keine Pins sie halten.</numerusform>
        </translation>
    </message>
    <message>
        <source>See Why</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Fill All, with Labels</source>
        <translation>Alle füllen, mit Marken</translation>
    </message>
    <message>
        <source>Leave Holes</source>
        <translation>Löcher lassen</translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>Add %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation>
            <numerusform>%n Pin</numerusform>
            <numerusform>%n Pins</numerusform>
        </translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 skalieren</translation>
    </message>
    <message>
        <source>%1 cannot go further: %2</source>
        <translation>%1 kann nicht weiter: %2</translation>
    </message>
    <message>
        <source>No pin was set: this place lies outside the shape.</source>
        <translation>Kein Pin: Diese Stelle liegt außerhalb der Form.</translation>
    </message>
    <message>
        <source>Cancelled: everything is as it was before the last change.</source>
        <translation>Abgebrochen: alles ist wie vor der letzten Änderung.</translation>
    </message>
    <message>
        <source>Meshing was cancelled. Any change, such as fewer vertices, starts it again.</source>
        <translation>Das Vernetzen wurde abgebrochen. Jede Änderung vernetzt neu, etwa weniger Punkte.</translation>
    </message>
    <message>
        <source>The motion was cancelled. Any change computes it again.</source>
        <translation>Die Bewegung wurde abgebrochen. Jede Änderung berechnet sie neu.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Widen %1</source>
        <translation>%1 weiten</translation>
    </message>
    <message>
        <source>%1 does not hold the shape at the time shown.</source>
        <translation>%1 hält die Form zur gezeigten Zeit nicht.</translation>
    </message>
    <message>
        <source>This replaces what came after; Undo brings it back.</source>
        <translation>Was danach kam, ist hierdurch ersetzt; Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>No pin was set where the mirror image lies outside the shape.</source>
        <translation>Wo ein Spiegelbild außerhalb der Form liegt, ist kein Pin.</translation>
    </message>
    <message>
        <source>There is already a pin where the mirror image would be.</source>
        <translation>Wo das Spiegelbild wäre, ist schon ein Pin.</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Mirror the motion of %1</source>
        <translation>Bewegung von %1 spiegeln</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 entsperren</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>Gruppierung von %1 aufheben</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>%1 gruppieren</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>%1 färben</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>%1 verknüpfen</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>Verknüpfung von %1 lösen</translation>
    </message>
    <message>
        <source>%1 is locked. A right-click or the list of pins unlocks it.</source>
        <translation>%1 ist gesperrt. Ein Rechtsklick oder die Liste der Pins entsperrt ihn.</translation>
    </message>
    <message>
        <source>%1 are locked. A right-click or the list of pins unlocks them.</source>
        <translation>%1 sind gesperrt. Ein Rechtsklick oder die Liste der Pins entsperrt sie.</translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1 gespiegelt</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>%1 aufnehmen</translation>
    </message>
    <message>
        <source>Recorded. K plays it; record other pins from the same time, and they move together.</source>
        <translation>Aufgenommen. K spielt es ab; andere Pins, vom selben Zeitpunkt an aufgenommen, bewegen sich gemeinsam.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>Weg bearbeiten</translation>
    </message>
    <message>
        <source>Draw the path of %1</source>
        <translation>Weg von %1 zeichnen</translation>
    </message>
    <message>
        <source>K plays it; draw the paths of other pins from the same time, and they move together.</source>
        <translation>K spielt ab; Wege anderer Pins von derselben Zeit an gezeichnet, und sie bewegen sich zusammen.</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Entspannen</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>This replaces what %1 did later; Undo brings it back.</source>
        <translation>Was %1 später tat, ist hierdurch ersetzt; Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>This circle is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Dieser Kreis ist kleiner als das Netz: ihn größer machen, oder das Netz feiner.</translation>
    </message>
    <message>
        <source>This ball is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Diese Kugel ist kleiner als das Netz: sie größer machen, oder das Netz feiner.</translation>
    </message>
    <message>
        <source>Pin %1 for the whole animation</source>
        <translation>%1 die ganze Animation lang halten</translation>
    </message>
    <message>
        <source>The film is longer by a second: what you had timed keeps its times.</source>
        <translation>Der Film ist eine Sekunde länger: Was Sie zeitlich festgelegt hatten, behält seine Zeiten.</translation>
    </message>
    <message>
        <source>The film is longer by a second. At an earlier time a drag sets the pose there.</source>
        <translation>Der Film ist eine Sekunde länger. Zu einer früheren Zeit setzt ein Ziehen dort die Pose.</translation>
    </message>
    <message>
        <source>Posed at %1 s: what comes before and after stays.</source>
        <translation>Pose bei %1 s: Davor und danach bleibt alles.</translation>
    </message>
    <message>
        <source>No pose was set where a pin begins, rotates or does not hold: show another time.</source>
        <translation>Wo ein Pin beginnt, dreht oder nicht hält, wurde keine Pose gesetzt: Zeigen Sie eine andere Zeit.</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 festhalten</translation>
    </message>
    <message>
        <source>The last move goes straight there now. Motion ▸ Keep the Path leads pins on instead.</source>
        <translation>Die letzte Bewegung führt jetzt gerade dorthin. Bewegung ▸ Weg behalten führt Pins stattdessen weiter.</translation>
    </message>
    <message>
        <source>%1 is in a part that is locked. The list of parts unlocks it.</source>
        <translation>%1 ist in einem gesperrten Teil. Die Liste der Teile entsperrt ihn.</translation>
    </message>
    <message>
        <source>A part is still being made. Pins can be dragged as soon as it is there.</source>
        <translation>Ein Teil wird noch gemacht. Sobald er da ist, lassen sich Pins ziehen.</translation>
    </message>
    <message>
        <source>The motion stops at %1 s: %2</source>
        <translation>Die Bewegung endet bei %1 s: %2</translation>
    </message>
</context>
<context>
    <name>wend::ShortcutDialog</name>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search for an action or for keys</source>
        <translation>Nach einem Befehl oder nach Tasten suchen</translation>
    </message>
    <message>
        <source>&amp;All Standard</source>
        <translation>&amp;Alle Standard</translation>
    </message>
    <message>
        <source>Give every action the keys that it has in a new Wend</source>
        <translation>Jedem Befehl die Tasten geben, die er in einem neuen Wend hat</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Click here, then press the keys</source>
        <translation>Hier klicken, dann die Tasten drücken</translation>
    </message>
    <message>
        <source>Leave the chosen action without keys</source>
        <translation>Den gewählten Befehl ohne Tasten lassen</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it has in a new Wend</source>
        <translation>Dem gewählten Befehl die Tasten geben, die er in einem neuen Wend hat</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Choose an action, then press the keys that it shall have.</source>
        <translation>Einen Befehl wählen, dann die Tasten drücken, die er haben soll.</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: the canvas uses it.</source>
        <translation>%1 lässt sich nicht wählen: die Zeichenfläche braucht es.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>Weggenommen von %1.</translation>
    </message>
</context>
<context>
    <name>wend::SideWindows</name>
    <message>
        <source>As it was opened</source>
        <translation>Wie es geöffnet wurde</translation>
    </message>
    <message>
        <source>What was done; a click goes back or forward to that step.</source>
        <translation>Was getan wurde; ein Klick geht zu diesem Schritt zurück oder vor.</translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation>Über Wend</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Biegt Bilder und Körper, indem es sie fließen lässt.&lt;/p&gt;&lt;p&gt;Nach J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU Affero General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>wend::SolidActions</name>
    <message>
        <source>Through the &amp;Solid</source>
        <translation>D&amp;urch den Körper</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Take hold of all that the cut takes away, as one handle</source>
        <translation>Alles, was der Schnitt wegnimmt, als einen Griff halten</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Flat Faces</source>
        <translation>&amp;Flache Dreiecke</translation>
    </message>
    <message>
        <source>Shade every triangle by itself instead of smoothly</source>
        <translation>Jedes Dreieck für sich statt glatt schattieren</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Parallel View</source>
        <translation>&amp;Parallele Ansicht</translation>
    </message>
    <message>
        <source>See without perspective</source>
        <translation>Ohne Perspektive sehen</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>&amp;Cut Open</source>
        <translation>&amp;Aufschneiden</translation>
    </message>
    <message>
        <source>Look inside along a plane; an arrow and rings move and tilt it</source>
        <translation>Entlang einer Ebene hineinsehen; Pfeil und Ringe verschieben und kippen sie</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Look along an axis of the world</source>
        <translation>Entlang einer Achse der Welt sehen</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>7</source>
        <translation>7</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Schräg</translation>
    </message>
    <message>
        <source>Look from the side and above</source>
        <translation>Schräg von oben sehen</translation>
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
        <translation>Rechte oder mittlere Taste dreht, mit Umschalt verschiebt sie; das Rad zoomt</translation>
    </message>
    <message>
        <source>Like &amp;VTK</source>
        <translation>Wie &amp;VTK</translation>
    </message>
    <message>
        <source>Left button turns, middle moves, right zooms, as in ParaView</source>
        <translation>Linke Taste dreht, mittlere verschiebt, rechte zoomt, wie in ParaView</translation>
    </message>
    <message>
        <source>Like &amp;Blender</source>
        <translation>Wie &amp;Blender</translation>
    </message>
    <message>
        <source>Middle button turns, with Shift moves, with Ctrl zooms</source>
        <translation>Mittlere Taste dreht, mit Umschalt verschiebt, mit Strg zoomt sie</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>&amp;Körper</translation>
    </message>
    <message>
        <source>L&amp;ook from</source>
        <translation>Se&amp;hen von</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Zuerst einen Körper öffnen.</translation>
    </message>
    <message>
        <source>Show the detailed or textured surface embedded in the solid; off: the border of the tetrahedra, which bend</source>
        <translation>Die feine oder bemalte Oberfläche zeigen, die im Körper mitgeht; aus: der Rand der Tetraeder, die sich biegen</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>The solid has neither a detailed surface nor materials.</source>
        <translation>Der Körper hat weder eine feine Oberfläche noch Materialien.</translation>
    </message>
    <message>
        <source>Rectangle, lasso and brush also take or select what is hidden</source>
        <translation>Rechteck, Lasso und Pinsel nehmen oder wählen auch, was verdeckt ist</translation>
    </message>
    <message>
        <source>Embed a detailed, perhaps textured surface from a file in the solid</source>
        <translation>Eine feine, vielleicht texturierte Oberfläche aus einer Datei im Körper mitreiten lassen</translation>
    </message>
    <message>
        <source>Show and export the solid with its own surface again</source>
        <translation>Den Körper wieder mit seiner eigenen Oberfläche zeigen und exportieren</translation>
    </message>
    <message>
        <source>No detailed surface was chosen for the solid.</source>
        <translation>Für den Körper wurde keine feine Oberfläche gewählt.</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Das Netz kommt aus einer Datei und wird verwendet, wie es ist.</translation>
    </message>
    <message>
        <source>Grab Beyond the &amp;Cut</source>
        <translation>Jenseits des &amp;Schnitts fassen</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>&amp;Haut</translation>
    </message>
    <message>
        <source>Choose Sk&amp;in…</source>
        <translation>Ha&amp;ut wählen…</translation>
    </message>
    <message>
        <source>Re&amp;move Skin</source>
        <translation>Haut &amp;entfernen</translation>
    </message>
    <message>
        <source>Which axis of the world points up in the view; kept with the project</source>
        <translation>Welche Achse der Welt in der Ansicht nach oben zeigt; wird mit dem Projekt gespeichert</translation>
    </message>
    <message>
        <source>&amp;X Points Up</source>
        <translation>&amp;X zeigt nach oben</translation>
    </message>
    <message>
        <source>&amp;Y Points Up</source>
        <translation>&amp;Y zeigt nach oben</translation>
    </message>
    <message>
        <source>&amp;Z Points Up</source>
        <translation>&amp;Z zeigt nach oben</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>Obe&amp;re Achse</translation>
    </message>
</context>
<context>
    <name>wend::SolidCanvas</name>
    <message>
        <source>there is not enough memory for a picture of %1 x %2 pixels</source>
        <translation>der Speicher reicht nicht für ein Bild von %1 x %2 Pixeln</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>Das Bild wird geschrieben …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Zelle %1</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Der Film wird geschrieben …</translation>
    </message>
</context>
<context>
    <name>wend::SolidWorkshop</name>
    <message>
        <source>Solids need OpenGL 3.3, which this system does not have. The command line (wend run) still works with them.</source>
        <translation>Körper brauchen OpenGL 3.3, das dieses System nicht hat. Die Befehlszeile (wend run) arbeitet trotzdem mit ihnen.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>Nichts wurde geschrieben. %1</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>These pictures of the surface cannot be read: %1</source>
        <translation>Diese Bilder der Oberfläche sind nicht zu lesen: %1</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>Die Form wird noch berechnet. Versuchen Sie es gleich noch einmal.</translation>
    </message>
</context>
<context>
    <name>wend::SoundTrack</name>
    <message>
        <source>The sound is not shown: that needs the program ffmpeg (Debian: sudo apt install ffmpeg).</source>
        <translation>Der Ton wird nicht gezeigt: Das braucht das Programm ffmpeg (Debian: sudo apt install ffmpeg).</translation>
    </message>
    <message>
        <source>The sound %1 cannot be read: is the file there?</source>
        <translation>Der Ton %1 ist nicht lesbar: Ist die Datei da?</translation>
    </message>
</context>
<context>
    <name>wend::SpringOffer</name>
    <message>
        <source>What comes back leaves the shape a little different, so that a loop jumps. If the shape springs back fully, it is as it was.</source>
        <translation>Was zurückkehrt, hinterlässt die Form etwas anders, sodass eine Schleife springt. Federt die Form vollständig zurück, ist sie wie zuvor.</translation>
    </message>
    <message>
        <source>Spring Back Fully</source>
        <translation>Vollständig zurückfedern</translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation>Ein Bild anpinnen, in Form ziehen und fließen lassen.</translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation>Ein Bild hier ablegen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation>Ein Bild, ein ebenes Netz oder ein Projekt auswählen.</translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation>Ein Beispiel ausprobieren</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Five-minute tutorial</source>
        <translation>Einführung in fünf Minuten</translation>
    </message>
    <message>
        <source>The first steps on a sample, one after another.</source>
        <translation>Die ersten Schritte an einem Beispiel, einer nach dem anderen.</translation>
    </message>
    <message>
        <source>Not saved when Wend ended</source>
        <translation>Nicht gespeichert, als Wend endete</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen…</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 verwerfen</translation>
    </message>
    <message>
        <source>Deletes these changes for good.</source>
        <translation>Vergisst diese Änderungen endgültig.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.
PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too.</source>
        <translation>PNG, JPEG, TIFF, EXR, WebP … – am besten freigestellt mit Transparenz.
PSD, ORA, KRA und SVG mit ihren Ebenen. Auch Projekte, Netze und Körper.</translation>
    </message>
</context>
<context>
    <name>wend::StatusFields</name>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Where the pointer is, in the picture&apos;s pixels</source>
        <translation>Wo der Zeiger ist, in Pixeln des Bildes</translation>
    </message>
    <message>
        <source>Area change</source>
        <translation>Flächenänderung</translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation>Wie viel größer oder kleiner die Form ist als in Ruhe</translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation>Fläche %1 %</translation>
    </message>
    <message>
        <source>volume %1 %</source>
        <translation>Volumen %1 %</translation>
    </message>
</context>
<context>
    <name>wend::SurfaceCheck</name>
    <message>
        <source>Save List</source>
        <translation>Liste speichern</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>Oberfläche reparieren</translation>
    </message>
    <message>
        <source>Triangles with missing points</source>
        <translation>Dreiecke mit fehlenden Punkten</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>Dreiecke, die sich durchdringen</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Edges of more than two</source>
        <translation>Kanten mit mehr als zweien</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>Doppelte Dreiecke</translation>
    </message>
    <message>
        <source>Turned neighbours</source>
        <translation>Verdrehte Nachbarn</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>Alle Punkte liegen in einer Ebene.</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Käfig bauen</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Nur die genaue Oberfläche</translation>
    </message>
    <message>
        <source>merge points (%1)</source>
        <translation>Punkte verschmelzen (%1)</translation>
    </message>
    <message>
        <source>drop triangles (%1)</source>
        <translation>Dreiecke weglassen (%1)</translation>
    </message>
    <message>
        <source>turn triangles (%1)</source>
        <translation>Dreiecke umdrehen (%1)</translation>
    </message>
    <message>
        <source>fill holes (%1)</source>
        <translation>Löcher füllen (%1)</translation>
    </message>
    <message>
        <source>It would %1.</source>
        <translation>Sie würde: %1.</translation>
    </message>
    <message>
        <source>No simple step fixes this one.</source>
        <translation>Kein einfacher Schritt bringt diesen Fehler in Ordnung.</translation>
    </message>
    <message>
        <source>add triangles (%1)</source>
        <translation>Dreiecke hinzufügen (%1)</translation>
    </message>
    <message>
        <source>It would leave %1 of %2 faults.</source>
        <translation>Es blieben %1 von %2 Fehlern.</translation>
    </message>
    <message>
        <source>Fix one fault</source>
        <translation>Einen Fehler beheben</translation>
    </message>
    <message>
        <source>No simple steps fix all of these.</source>
        <translation>Keine einfachen Schritte bringen sie alle in Ordnung.</translation>
    </message>
    <message>
        <source>Fix all faults of a kind</source>
        <translation>Alle Fehler einer Art beheben</translation>
    </message>
    <message>
        <source>Looking for what fixes all of these …</source>
        <translation>Sucht, was sie alle in Ordnung bringt …</translation>
    </message>
</context>
<context>
    <name>wend::SurfacePanel</name>
    <message>
        <source>Show them</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>Liste speichern …</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>The surface bounds no solid</source>
        <translation>Die Oberfläche umschließt keinen Körper</translation>
    </message>
    <message>
        <source>Show the triangles</source>
        <translation>Dreiecke zeigen</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Liste speichern</translation>
    </message>
    <message>
        <source>Writes the numbers of all wrong triangles and edges to a file.</source>
        <translation>Schreibt die Nummern aller fehlerhaften Dreiecke und Kanten in eine Datei.</translation>
    </message>
    <message>
        <source>Merges coincident points, drops degenerate and duplicate triangles, orients the others and fills small holes.</source>
        <translation>Fasst Punkte am selben Ort zusammen, entfernt entartete und doppelte Dreiecke, richtet sie aus und füllt kleine Löcher.</translation>
    </message>
    <message>
        <source>“Repair” helps.</source>
        <translation>„Reparieren“ hilft.</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was falsch ist</translation>
    </message>
    <message>
        <source>The kinds of faults, and how often each occurs.</source>
        <translation>Die Arten von Fehlern, und wie oft jede vorkommt.</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>Vorige Stelle</translation>
    </message>
    <message>
        <source>Goes to the previous place where this is wrong.</source>
        <translation>Sieht die vorige Stelle an, an der dies falsch ist.</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>Nächste Stelle</translation>
    </message>
    <message>
        <source>Goes to the next place where this is wrong.</source>
        <translation>Sieht die nächste Stelle an, an der dies falsch ist.</translation>
    </message>
    <message>
        <source>Colours the triangles that are wrong and shows them: what hides them is left out.</source>
        <translation>Färbt die fehlerhaften Dreiecke und sieht sie an: was sie verdeckt, wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The surface is embedded in a cage</source>
        <translation>Die Oberfläche fährt in einem Käfig mit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>“Repair” does not help: a cage around it can carry it.</source>
        <translation>„Reparieren“ hilft nicht: ein Käfig um sie herum kann sie tragen.</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Nur die genaue Oberfläche</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Käfig bauen</translation>
    </message>
    <message>
        <source>Removes the cage: without a repair there is then no solid.</source>
        <translation>Nimmt den Käfig weg: ohne Reparatur gibt es dann keinen Körper.</translation>
    </message>
    <message>
        <source>Fills a cage of even cells around the surface, which is embedded in it.</source>
        <translation>Füllt einen Käfig gleichmäßiger Zellen um die Oberfläche, die in ihm mitfährt.</translation>
    </message>
    <message>
        <source>See the repair</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Shows the surface as the repair would leave it: what it adds in green, what stays wrong in red.</source>
        <translation>Zeigt die Oberfläche, wie die Reparatur sie hinterließe: was sie ergänzt, grün, was falsch bleibt, rot.</translation>
    </message>
    <message>
        <source>There is nothing that the simple repairs would change.</source>
        <translation>Es gibt nichts, was die einfachen Reparaturen ändern würden.</translation>
    </message>
    <message>
        <source>Fix this one</source>
        <translation>Diesen beheben</translation>
    </message>
    <message>
        <source>Fixes only what is shown: what it adds is green, what it takes away or turns is yellow.</source>
        <translation>Bringt nur in Ordnung, was betrachtet wird: Was hinzukommt, ist grün; was wegfällt oder gedreht wird, gelb.</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>Alle beheben</translation>
    </message>
    <message>
        <source>Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no more edges than chosen below.</source>
        <translation>Bringt von dieser Art alles in Ordnung, was einfache Schritte können, in einem Schritt, der sich rückgängig machen lässt; von Löchern die mit höchstens so vielen Kanten, wie unten gewählt sind.</translation>
    </message>
    <message>
        <source>“Repair” does not help: the cage carries the surface as it is.</source>
        <translation>„Reparieren“ hilft nicht: der Käfig trägt die Oberfläche, wie sie ist.</translation>
    </message>
    <message>
        <source>One hole has %1 edges: fill up to %1</source>
        <translation>Ein Loch hat %1 Kanten: bis %1 füllen</translation>
    </message>
    <message>
        <source>%1 holes have up to %2 edges: fill up to %2</source>
        <translation>%1 Löcher haben bis zu %2 Kanten: bis %2 füllen</translation>
    </message>
    <message>
        <source>No hole is larger</source>
        <translation>Kein Loch ist größer</translation>
    </message>
    <message>
        <source>Sets the largest hole that the repair fills to this.</source>
        <translation>Setzt das größte Loch, das die Reparatur füllt, auf diesen Wert.</translation>
    </message>
</context>
<context>
    <name>wend::TimeRuler</name>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Drag to show another time; with Shift, mark the part that a loop repeats. A right-click counts frames, sets the frame rate, and adds markers</source>
        <translation>Ziehen zeigt eine andere Zeit; mit Umschalt markiert es den Teil, den eine Schleife wiederholt. Ein Rechtsklick zählt Bilder, stellt die Bildrate ein und setzt Marken</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>Marke verschieben</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Zyklus ändern</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Rename Marker</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Name of the marker:</source>
        <translation>Name der Marke:</translation>
    </message>
    <message>
        <source>Rename marker</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Frame &amp;Rate</source>
        <translation>Bild&amp;rate</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Cycle &amp;from Here</source>
        <translation>Zyklus &amp;ab hier</translation>
    </message>
    <message>
        <source>Cycle &amp;to Here</source>
        <translation>Zyklus &amp;bis hier</translation>
    </message>
    <message>
        <source>&amp;No Cycle</source>
        <translation>&amp;Kein Zyklus</translation>
    </message>
    <message>
        <source>Remove cycle</source>
        <translation>Zyklus entfernen</translation>
    </message>
    <message>
        <source>&amp;Count Frames</source>
        <translation>Bilder &amp;zählen</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>&amp;Marke setzen</translation>
    </message>
    <message>
        <source>R&amp;ename Marker…</source>
        <translation>Marke &amp;umbenennen…</translation>
    </message>
    <message>
        <source>Re&amp;move Marker</source>
        <translation>Marke &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Play the &amp;Sound</source>
        <translation>&amp;Ton abspielen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cycle: %1 to %2</source>
        <translation>Zyklus: %1 bis %2</translation>
    </message>
    <message>
        <source>frames at %1 fps</source>
        <translation>Bilder, %1 fps</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Show Key &amp;Poses</source>
        <translation>Schlüssel&amp;posen zeigen</translation>
    </message>
</context>
<context>
    <name>wend::TimeScale</name>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
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
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation>Welcher Augenblick der Bewegung gezeigt wird.</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Noch bewegt sich nichts: einen Pin ziehen.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>How long the film is. The poses stay as they are, however fast it goes.</source>
        <translation>Wie lang der Film ist. Die Posen bleiben, wie sie sind, so schnell er auch läuft.</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>Länge ändern</translation>
    </message>
    <message>
        <source>%1 /</source>
        <translation>%1 /</translation>
    </message>
    <message>
        <source>Drag a pin to begin</source>
        <translation>Zum Beginnen einen Pin ziehen</translation>
    </message>
</context>
<context>
    <name>wend::Toolbox</name>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>What bends, and how finely</source>
        <translation>Was sich biegt und wie fein</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pins</translation>
    </message>
    <message>
        <source>Hold parts and drag them</source>
        <translation>Teile halten und ziehen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>What it is made of: soft, stiff, and what is kept where</source>
        <translation>Woraus es ist: weich, steif und was wo erhalten bleibt</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animieren</translation>
    </message>
    <message>
        <source>How it moves in time</source>
        <translation>Wie es sich in der Zeit bewegt</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Zuerst ein Bild öffnen.</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Zuerst einen Körper öffnen.</translation>
    </message>
    <message>
        <source>Write pictures, sequences, ST maps and meshes</source>
        <translation>Bilder, Sequenzen, ST-Maps und Netze schreiben</translation>
    </message>
</context>
<context>
    <name>wend::TrackChoice</name>
    <message>
        <source>Move in time</source>
        <translation>Zeitlich verschieben</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>Bewegung entfernen</translation>
    </message>
    <message>
        <source>Remove motions</source>
        <translation>Bewegungen entfernen</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Easing ändern</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Gerade machen</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Schlüsselposen verschieben</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Schlüsselpose verschieben</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Schlüsselposen entfernen</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Schlüsselpose entfernen</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Schlüsselposen einfügen</translation>
    </message>
    <message>
        <source>Mirror keys</source>
        <translation>Schlüsselposen spiegeln</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Nothing changes: where a pin begins it is at rest, and rotations keep their course.</source>
        <translation>Nichts ändert sich: Wo ein Pin beginnt, ist er in Ruhe, und Drehungen behalten ihren Verlauf.</translation>
    </message>
</context>
<context>
    <name>wend::TrackView</name>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalieren</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Zeitlich verschieben</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>Dauer ändern</translation>
    </message>
    <message>
        <source>&amp;Remove Motion</source>
        <translation>Bewegung &amp;entfernen</translation>
    </message>
    <message>
        <source>Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears here, pin by pin.</source>
        <translation>Noch bewegt sich nichts. Ziehen Sie einen Pin, oder nehmen Sie es mit Strg auf: Dann steht hier, Pin für Pin, was Sie getan haben.</translation>
    </message>
    <message>
        <source>Change when it holds</source>
        <translation>Ändern, wann er hält</translation>
    </message>
    <message>
        <source>&amp;Remove Motions</source>
        <translation>Bewegungen &amp;entfernen</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Easing</translation>
    </message>
    <message>
        <source>&amp;Paste at the Time Shown</source>
        <translation>Bei der gezeigten Zeit e&amp;infügen</translation>
    </message>
    <message>
        <source>Paste M&amp;irrored</source>
        <translation>&amp;Gespiegelt einfügen</translation>
    </message>
    <message>
        <source>&amp;Straighten</source>
        <translation>&amp;Gerade machen</translation>
    </message>
    <message>
        <source>Simplify to &amp;Keys</source>
        <translation>Zu &amp;Schlüsselposen vereinfachen</translation>
    </message>
    <message>
        <source>&amp;Few</source>
        <translation>&amp;Wenige</translation>
    </message>
    <message>
        <source>&amp;Some</source>
        <translation>&amp;Einige</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>&amp;Viele</translation>
    </message>
    <message>
        <source>Key at %1</source>
        <translation>Schlüsselpose: %1</translation>
    </message>
    <message>
        <source>Holds from %1 to %2</source>
        <translation>Hält von %1 bis %2</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4</source>
        <translation>%1: %2 bis %3, %4</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
    <message>
        <source>Slow &amp;before It</source>
        <translation>&amp;Davor langsam</translation>
    </message>
    <message>
        <source>Slow &amp;after It</source>
        <translation>Dan&amp;ach langsam</translation>
    </message>
    <message>
        <source>Slow on B&amp;oth Sides</source>
        <translation>&amp;Beiderseits langsam</translation>
    </message>
    <message>
        <source>&amp;Hold to the Next</source>
        <translation>Bis zur nächsten &amp;halten</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>S&amp;piegeln</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Remove Keys</source>
        <translation>Schlüsselposen &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Remove Key</source>
        <translation>Schlüsselpose &amp;entfernen</translation>
    </message>
    <message>
        <source>A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right another time, with Alt they move the chosen bar or keys</source>
        <translation>Eine Zeile je Pin, ein Balken je Bewegung; Auf und Ab wählen einen Pin, Links und Rechts eine andere Zeit, mit Alt bewegen sie den gewählten Balken oder Schlüsselposen</translation>
    </message>
    <message>
        <source>Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds</source>
        <translation>Eine Schlüsselpose (Raute) oder einen Balken zu einer anderen Zeit ziehen; Umschalt, Strg oder ein Rahmen um sie wählt mehrere. Ein Rechtsklick bietet Easing, Halten, Kopieren, Spiegeln. Die Enden der Linie sagen, wann der Pin hält</translation>
    </message>
    <message>
        <source>Easing Curve</source>
        <translation>Easing-Kurve</translation>
    </message>
    <message>
        <source>Easing C&amp;urve…</source>
        <translation>Easing-K&amp;urve …</translation>
    </message>
</context>
<context>
    <name>wend::Tutorial</name>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ends the tutorial; the picture stays open</source>
        <translation>Beendet die Einführung; das Bild bleibt offen</translation>
    </message>
    <message>
        <source>Only what is pinned holds. &lt;b&gt;Click a hoof&lt;/b&gt; of the giraffe to pin it.</source>
        <translation>Nur was festgesteckt ist, hält. &lt;b&gt;Klicken Sie auf einen Huf&lt;/b&gt; der Giraffe, um ihn festzustecken.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pin the other hooves&lt;/b&gt;, too, with a click each. Ctrl+Z undoes a pin.</source>
        <translation>&lt;b&gt;Stecken Sie auch die anderen Hufe fest&lt;/b&gt;, je mit einem Klick. Strg+Z nimmt einen Pin zurück.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click its nose&lt;/b&gt;, and &lt;b&gt;drag the new pin&lt;/b&gt; down to the ground. The shape flows along.</source>
        <translation>&lt;b&gt;Klicken Sie auf die Nase&lt;/b&gt; und &lt;b&gt;ziehen Sie den neuen Pin&lt;/b&gt; hinunter zum Boden. Die Form fließt mit.</translation>
    </message>
    <message>
        <source>What it keeps on the way is your choice: at the top right, under &lt;b&gt;Keep&lt;/b&gt;, &lt;b&gt;choose Area, Rigid or Angle&lt;/b&gt;, and see the neck change.</source>
        <translation>Was sie dabei bewahrt, bestimmen Sie: Wählen Sie oben rechts, unter &lt;b&gt;Erhalt&lt;/b&gt;, &lt;b&gt;Fläche, Starr oder Winkel&lt;/b&gt;, und sehen Sie, wie sich der Hals ändert.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press D&lt;/b&gt; to see in colours what the bend has changed, and where most. D again hides it.</source>
        <translation>&lt;b&gt;Drücken Sie D&lt;/b&gt;: Farben zeigen, was die Biegung geändert hat, und wo am meisten. Noch einmal D blendet sie aus.</translation>
    </message>
    <message>
        <source>The same for a part only: &lt;b&gt;press Ctrl+3&lt;/b&gt; for the step &lt;i&gt;Paint&lt;/i&gt;, and &lt;b&gt;brush over the neck&lt;/b&gt;. [ and ] change the size of the brush.</source>
        <translation>Dasselbe nur für einen Teil: &lt;b&gt;Strg+3&lt;/b&gt; führt zum Schritt &lt;i&gt;Malen&lt;/i&gt;; &lt;b&gt;pinseln Sie über den Hals&lt;/b&gt;. [ und ] ändern die Größe des Pinsels.</translation>
    </message>
    <message>
        <source>Your drag is already a film: &lt;b&gt;press K&lt;/b&gt; to play it. Click into the strip below to go to a time, and drag on from there.</source>
        <translation>Ihr Ziehen ist schon ein Film: &lt;b&gt;K&lt;/b&gt; spielt ihn ab. Ein Klick in den Streifen unten führt zu einer Zeit, und von dort ziehen Sie weiter.</translation>
    </message>
    <message>
        <source>That is all you need to begin. &lt;b&gt;F1&lt;/b&gt; opens the manual, &lt;b&gt;?&lt;/b&gt; lists the keys. Drop a picture of your own on the window.</source>
        <translation>Mehr braucht es nicht für den Anfang. &lt;b&gt;F1&lt;/b&gt; öffnet das Handbuch, &lt;b&gt;?&lt;/b&gt; nennt die Tasten. Ziehen Sie ein eigenes Bild auf das Fenster.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Finally, &lt;b&gt;press Ctrl+5&lt;/b&gt; for the step &lt;i&gt;Export&lt;/i&gt;: a picture, a sequence, an ST map, or the mesh.</source>
        <translation>Zuletzt führt &lt;b&gt;Strg+5&lt;/b&gt; zum Schritt &lt;i&gt;Export&lt;/i&gt;: ein Bild, eine Bildfolge, eine ST-Map oder das Netz.</translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation>Ansicht des Körpers</translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation>Der Körper lässt sich nicht zeichnen: %1</translation>
    </message>
</context>
<context>
    <name>wend::WorkNote</name>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Abbrechen (Esc)</translation>
    </message>
    <message>
        <source>Stops what is being computed and goes back to the last complete state</source>
        <translation>Beendet, was berechnet wird, und geht zum letzten vollständigen Stand zurück</translation>
    </message>
    <message>
        <source>Computing the motion: %1 %</source>
        <translation>Die Bewegung wird berechnet: %1 %</translation>
    </message>
    <message>
        <source>Meshing %1 …</source>
        <translation>%1 wird vernetzt …</translation>
    </message>
    <message numerus="yes">
        <source>Meshing %1 with about %Ln vertices …</source>
        <translation>
            <numerusform>%1 wird mit etwa %Ln Punkt vernetzt …</numerusform>
            <numerusform>%1 wird mit etwa %Ln Punkten vernetzt …</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Filling the ground behind “%1” …</source>
        <translation>Der Grund hinter „%1“ wird gefüllt …</translation>
    </message>
</context>
</TS>
