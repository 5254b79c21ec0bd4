<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps area: parts neither grow nor shrink. Angles and lengths give way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps lengths best: a balance of area and angle. A good start for most pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns parts as if they were stiff. Area gives way where parts bend.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps angles: small details keep their form. Parts may grow or shrink a lot.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Opening</name>
    <message>
        <source>this is a solid; the window shows pictures and flat meshes so far. `wend run` and `wend mesh` work with solids.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag the pin; Esc puts the shape back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move the pin, Shift-click to select more, Delete to remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, then drag pins to bend it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or draw a rectangle to select pins, drag to move them, arrow keys nudge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a picture, a flat mesh or a project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the picture as it is bent now, at its full size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;Mesh…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;Frames…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export S&amp;T Map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the triangles that carry the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Distortion Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour the shape by its distortion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;Desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the motion, or pause it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the end of the motion, where dragging goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What pointer and keys do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::Canvas</name>
    <message>
        <source>Canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Distortion map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which error is coloured over the shape: of lengths, of areas or of angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the colours&apos; range, to compare different shapes and energies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the worst place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ma&amp;p of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area of the most distorted triangle against rest.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>Energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the shape keeps when it has to give way. From Area over Length and Rigid to Angle the error moves from angles to areas. Between two names the energy changes evenly.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Writing %n pictures …</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the map …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If you do not save, they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;table cellspacing=&apos;6&apos;&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Click&lt;/b&gt;&lt;/td&gt;&lt;td&gt;sets a pin&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Drag a pin&lt;/b&gt;&lt;/td&gt;&lt;td&gt;moves it; Esc puts it back&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Shift-click&lt;/b&gt;&lt;/td&gt;&lt;td&gt;selects several pins&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Drag beside pins&lt;/b&gt;&lt;/td&gt;&lt;td&gt;selects by rectangle&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrow keys&lt;/b&gt;&lt;/td&gt;&lt;td&gt;nudge by a pixel, with Shift by ten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Delete&lt;/b&gt;&lt;/td&gt;&lt;td&gt;removes the selected pins&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zooms to the pointer&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space or middle button&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pans&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Hold H&lt;/b&gt;&lt;/td&gt;&lt;td&gt;shows the bare picture&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::MaterialPanel</name>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Energy φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;moothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same choice as a number, as it stands in the project file: 0.002 keeps area, 0.464 length, 1.571 is rigid, 2.678 keeps angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull is spread, as a part of the shape&apos;s diagonal. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between %1 and %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::MeshPanel</name>
    <message>
        <source>Opaque part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, or the picture as a whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline is grown by this much, so that soft edges come along whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change mesh density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::SampleCard</name>
    <message>
        <source>Sample: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>%1 cannot go further: the shape would fold over. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion stops at %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, TIFF, EXR, JPEG, WebP — cut-outs with transparency work best. Projects and flat meshes too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::StatusFields</name>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the pointer is, in the picture&apos;s pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pin error %1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst distortion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The greatest length error of a triangle; 0 is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time per frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What computing the last frame took</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pin error %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::TimeStrip</name>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No motion yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
