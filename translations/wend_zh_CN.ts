<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>CheatSheet</name>
    <message>
        <source>Pointer</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>sets a pin</source>
        <translation>放置图钉</translation>
    </message>
    <message>
        <source>Drag a pin</source>
        <translation>拖动图钉</translation>
    </message>
    <message>
        <source>moves it; Esc puts it back</source>
        <translation>移动图钉；按 Esc 复原</translation>
    </message>
    <message>
        <source>Shift-click</source>
        <translation>按住 Shift 单击</translation>
    </message>
    <message>
        <source>selects several pins</source>
        <translation>选择多个图钉</translation>
    </message>
    <message>
        <source>Digits while dragging</source>
        <translation>拖动时输入数字</translation>
    </message>
    <message>
        <source>set the number; Enter confirms it</source>
        <translation>设定数值，按 Enter 确认</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>zooms to the pointer</source>
        <translation>以指针为中心缩放</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ 和 ]</translation>
    </message>
    <message>
        <source>size of a brush</source>
        <translation>画笔大小</translation>
    </message>
    <message>
        <source>Hold H</source>
        <translation>按住 H</translation>
    </message>
    <message>
        <source>Hold \</source>
        <translation>按住 \</translation>
    </message>
    <message>
        <source>shows the shape before it was bent</source>
        <translation>显示变形前的形状</translation>
    </message>
    <message>
        <source>X, Y, Z while dragging</source>
        <translation>拖动时按 X、Y、Z</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>锁定轴</translation>
    </message>
    <message>
        <source>Right or middle button</source>
        <translation>右键或中键</translation>
    </message>
    <message>
        <source>turns the view; with Shift, moves it</source>
        <translation>旋转视图；按住 Shift 平移</translation>
    </message>
    <message>
        <source>Middle click</source>
        <translation>单击中键</translation>
    </message>
    <message>
        <source>sets the point to turn around</source>
        <translation>设定旋转中心</translation>
    </message>
    <message>
        <source>widens it to a circle</source>
        <translation>扩大为圆</translation>
    </message>
    <message>
        <source>Drag the ring&apos;s dot or square</source>
        <translation>拖动圆环上的圆点或方块</translation>
    </message>
    <message>
        <source>rotates or scales; Shift snaps to 15°</source>
        <translation>旋转或缩放；按住 Shift 以 15° 为步长</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>nudge by a pixel, with Shift by ten</source>
        <translation>移动 1 像素，按住 Shift 移动 10 像素</translation>
    </message>
    <message>
        <source>pans</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Shift-click with the brush</source>
        <translation>用画笔 Shift+单击</translation>
    </message>
    <message>
        <source>paints a straight line</source>
        <translation>画一条直线</translation>
    </message>
    <message>
        <source>Arrow keys without a pin</source>
        <translation>没有图钉时按方向键</translation>
    </message>
    <message>
        <source>move a cross, Enter clicks there</source>
        <translation>移动十字，Enter 在那里单击</translation>
    </message>
    <message>
        <source>Alt-right-drag a brush</source>
        <translation>用画笔 Alt+右键拖动</translation>
    </message>
    <message>
        <source>changes its size and hardness</source>
        <translation>更改其大小和硬度</translation>
    </message>
    <message>
        <source>Tap the space bar</source>
        <translation>轻按空格键</translation>
    </message>
    <message>
        <source>plays or pauses; held, it moves the view</source>
        <translation>播放或暂停；按住时移动视图</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>中键</translation>
    </message>
    <message>
        <source>hides pins and overlays</source>
        <translation>隐藏图钉和叠加层</translation>
    </message>
    <message>
        <source>Ctrl+Shift-drag a pin</source>
        <translation>Ctrl+Shift 拖动图钉</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>轨道</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>上、下</translation>
    </message>
    <message>
        <source>choose a pin</source>
        <translation>选择图钉</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>左、右</translation>
    </message>
    <message>
        <source>show another time</source>
        <translation>显示别的时间</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+左、Alt+右</translation>
    </message>
    <message>
        <source>move the chosen bars or keys</source>
        <translation>移动所选的条或关键姿势</translation>
    </message>
    <message>
        <source>Shift-click, or a frame</source>
        <translation>按住 Shift 单击，或框选</translation>
    </message>
    <message>
        <source>chooses several</source>
        <translation>选择多个</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>opens their easing curve</source>
        <translation>打开其缓动曲线</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C、Ctrl+V</translation>
    </message>
    <message>
        <source>copy keys, paste them at the time shown</source>
        <translation>复制关键姿势，粘贴到所示时间</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>pastes them mirrored</source>
        <translation>镜像粘贴</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>I, O</source>
        <translation>I、O</translation>
    </message>
    <message>
        <source>begin and end the cycle here</source>
        <translation>在此开始、结束循环段</translation>
    </message>
    <message>
        <source>Shift-drag the numbers</source>
        <translation>按住 Shift 拖动数字</translation>
    </message>
    <message>
        <source>marks the cycle</source>
        <translation>标出循环段</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>adds a marker</source>
        <translation>添加标记</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>at time %1 %2 cannot go on: %3</source>
        <translation>在时刻 %1，%2 无法继续：%3</translation>
    </message>
    <message>
        <source>at time %1 the shape is too stiff to settle further near %2: the steps would be too short; allow a larger tolerance</source>
        <translation>在时刻 %1，形状在 %2 附近过于坚硬，无法继续松弛：步长会过短；请放宽容差</translation>
    </message>
    <message>
        <source>the shape would fold over near %1, in cell %2; move it less far or along another path, or release what holds the shape there</source>
        <translation>形状会在 %1 附近的单元 %2 处翻折；请移动得近一些或换一种方式，或松开在那里固定形状的东西</translation>
    </message>
    <message>
        <source>the shape would fold over near %1; move it less far or along another path, or release what holds the shape there</source>
        <translation>形状会在 %1 附近翻折；请移动得近一些或换一种方式，或松开在那里固定形状的东西</translation>
    </message>
    <message>
        <source>it moves too fast near %1: the steps would be too short; give its motion more time, or allow a larger tolerance</source>
        <translation>在 %1 附近过快，步长会过短；请给运动更多时间，或放宽容差</translation>
    </message>
    <message>
        <source>the shape near %1 is stretched or squeezed so much that no velocity can be computed; move it less far, or make the material or the mesh more even there</source>
        <translation>形状在 %1 附近被拉伸或压缩得过多，无法计算速度；请移动得近一些，或使那里的材质或网格更均匀</translation>
    </message>
    <message>
        <source>it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time</source>
        <translation>在 %1 附近过快，数值溢出；请移动得近一些，或给运动更多时间</translation>
    </message>
    <message>
        <source>the shape needs about %1 of memory; %2 are free; fewer vertices need less</source>
        <translation>该形状约需 %1 内存；可用 %2；减少顶点可降低需求</translation>
    </message>
    <message>
        <source>%1 and %2 move the point %3 in different ways at time %4</source>
        <translation>%1 和 %2 在时刻 %4 以不同方式移动点 %3</translation>
    </message>
    <message>
        <source>handle &quot;%1&quot;</source>
        <translation>图钉“%1”</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>图钉 %1</translation>
    </message>
    <message>
        <source>the shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>its region holds no vertex</source>
        <translation>其区域内没有顶点</translation>
    </message>
    <message>
        <source>vertex %1 belongs to no cell</source>
        <translation>顶点 %1 不属于任何单元</translation>
    </message>
    <message>
        <source>the picture has no alpha channel to take an outline from</source>
        <translation>图片没有可用于提取轮廓的 Alpha 通道</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>图片没有像素</translation>
    </message>
    <message>
        <source>no part of the picture is as large as %1 pixels</source>
        <translation>图片中没有任何部分达到 %1 像素</translation>
    </message>
    <message>
        <source>the picture is fully transparent</source>
        <translation>图片完全透明</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha is nowhere above the threshold of %1 %</source>
        <translation>图片的 Alpha 处处不超过阈值 %1 %</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha has too many contours: it looks like noise</source>
        <translation>图片的 Alpha 轮廓过多：看起来像噪声</translation>
    </message>
    <message>
        <source>the outline is empty</source>
        <translation>轮廓为空</translation>
    </message>
    <message>
        <source>the outline crosses or overlaps itself near %1</source>
        <translation>轮廓在 %1 附近自相交或重叠</translation>
    </message>
    <message>
        <source>the outline cannot be triangulated (%1)</source>
        <translation>轮廓无法三角化 (%1)</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same, %3</source>
        <translation>点 %1 和 %2 相同，%3</translation>
    </message>
    <message>
        <source>point %1, %2, is outside the shape</source>
        <translation>点 %1，%2，在形状之外</translation>
    </message>
    <message>
        <source>an edge length of %1 would take more than %2 vertices</source>
        <translation>边长 %1 需要超过 %2 个顶点</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>为空</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>不存在</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>是管道，不是文件</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>是设备，不是文件</translation>
    </message>
    <message>
        <source>is a symbolic link that leads back to itself</source>
        <translation>是指回自身的符号链接</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>磁盘可能已满</translation>
    </message>
    <message>
        <source>the disk is full, only %1 are free</source>
        <translation>磁盘已满，仅剩 %1</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>文件夹 %1 不存在</translation>
    </message>
    <message>
        <source>the folder %1 is not writable</source>
        <translation>文件夹 %1 不可写</translation>
    </message>
    <message>
        <source>is read-only: make it writable first, or choose another name</source>
        <translation>是只读的：请先使其可写，或选择其他名称</translation>
    </message>
    <message>
        <source>is a model or a mesh of a kind that is not read (%1); these are: %2</source>
        <translation>是无法读取的模型或网格类型（%1）；可以读取：%2</translation>
    </message>
    <message>
        <source>a JPEG XL picture</source>
        <translation>JPEG XL 图片</translation>
    </message>
    <message>
        <source>a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)</source>
        <translation>GIMP 图片 (XCF;请从 GIMP 导出为 PNG 或 OpenRaster)</translation>
    </message>
    <message>
        <source>has a layer &quot;%1&quot; with an opacity out of range: it is limited to 0 … 100 %</source>
        <translation>图层“%1”的不透明度超出范围:限制为 0 … 100 %</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文档</translation>
    </message>
    <message>
        <source>a film</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ZIP 压缩包</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>文本文件</translation>
    </message>
    <message>
        <source>not a picture that Wend knows</source>
        <translation>Wend 不认识的图片</translation>
    </message>
    <message>
        <source>cannot be read as a picture: %1</source>
        <translation>无法作为图片读取：%1</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>没有像素</translation>
    </message>
    <message>
        <source>is a volume, not a picture</source>
        <translation>是体数据，不是图片</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than %3 million</source>
        <translation>有 %1 × %2 像素，超过 %3 百万</translation>
    </message>
    <message>
        <source>is truncated or corrupt</source>
        <translation>被截断或已损坏</translation>
    </message>
    <message>
        <source>is transparent everywhere</source>
        <translation>处处透明</translation>
    </message>
    <message>
        <source>holds tetrahedra, but the project is in the plane</source>
        <translation>包含四面体，但项目是平面的</translation>
    </message>
    <message>
        <source>holds no tetrahedra, but the project is in space</source>
        <translation>不含四面体，但项目是空间的</translation>
    </message>
    <message>
        <source>the surface has no triangle</source>
        <translation>表面没有三角形</translation>
    </message>
    <message>
        <source>the surface has no extent</source>
        <translation>表面没有大小</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>表面没有包围体积</translation>
    </message>
    <message>
        <source>the surface bounds no volume: %1</source>
        <translation>表面没有围成体积：%1</translation>
    </message>
    <message>
        <source>the surface intersects itself</source>
        <translation>表面自相交</translation>
    </message>
    <message>
        <source>the surface has features too small for its size</source>
        <translation>表面的细节相对其尺寸过小</translation>
    </message>
    <message>
        <source>two facets of the surface lie almost on each other</source>
        <translation>表面的两个面几乎重叠</translation>
    </message>
    <message>
        <source>the volume mesher ran out of memory</source>
        <translation>体网格生成器内存不足</translation>
    </message>
    <message>
        <source>the volume mesher did not finish within %1 s of computing; a coarser quality or a larger maxVolume may help</source>
        <translation>体网格生成器在 %1 秒计算内未完成；降低质量或增大四面体可能有帮助</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>所有点位于同一平面</translation>
    </message>
    <message>
        <source>%1 open edge (first: %2)</source>
        <translation>%1 条开放边（%2）</translation>
    </message>
    <message>
        <source>%1 open edges (first: %2)</source>
        <translation>%1 条开放边（首个：%2）</translation>
    </message>
    <message>
        <source>%1 edge of more than two triangles (first: %2)</source>
        <translation>%1 条边属于两个以上三角形（%2）</translation>
    </message>
    <message>
        <source>%1 edges of more than two triangles (first: %2)</source>
        <translation>%1 条边属于两个以上三角形（首个：%2）</translation>
    </message>
    <message>
        <source>%1 pair of triangles that intersect (first: %2)</source>
        <translation>%1 对相交的三角形（%2）</translation>
    </message>
    <message>
        <source>%1 pairs of triangles that intersect (first: %2)</source>
        <translation>%1 对相交的三角形（首个：%2）</translation>
    </message>
    <message>
        <source>%1 triangle without area (first: %2)</source>
        <translation>%1 个无面积的三角形（%2）</translation>
    </message>
    <message>
        <source>%1 triangles without area (first: %2)</source>
        <translation>%1 个无面积的三角形（首个：%2）</translation>
    </message>
    <message>
        <source>%1 duplicate triangle (first: %2)</source>
        <translation>%1 个重复的三角形（%2）</translation>
    </message>
    <message>
        <source>%1 duplicate triangles (first: %2)</source>
        <translation>%1 个重复的三角形（首个：%2）</translation>
    </message>
    <message>
        <source>%1 edge where the orientation changes (first: %2)</source>
        <translation>%1 条边处方向改变（%2）</translation>
    </message>
    <message>
        <source>%1 edges where the orientation changes (first: %2)</source>
        <translation>%1 条边处方向改变（首个：%2）</translation>
    </message>
    <message>
        <source>the surface was repaired: %1</source>
        <translation>表面已修复：%1</translation>
    </message>
    <message>
        <source>%1 coincident vertex merged</source>
        <translation>合并 %1 个重合顶点</translation>
    </message>
    <message>
        <source>%1 coincident vertices merged</source>
        <translation>合并 %1 个重合顶点</translation>
    </message>
    <message>
        <source>%1 triangle without area dropped</source>
        <translation>删除 %1 个无面积三角形</translation>
    </message>
    <message>
        <source>%1 triangles without area dropped</source>
        <translation>删除 %1 个无面积三角形</translation>
    </message>
    <message>
        <source>%1 duplicate triangle dropped</source>
        <translation>删除 %1 个重复三角形</translation>
    </message>
    <message>
        <source>%1 duplicate triangles dropped</source>
        <translation>删除 %1 个重复三角形</translation>
    </message>
    <message>
        <source>%1 triangle turned over</source>
        <translation>翻转 %1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles turned over</source>
        <translation>翻转 %1 个三角形</translation>
    </message>
    <message>
        <source>%1 hole filled</source>
        <translation>填补 %1 个孔洞</translation>
    </message>
    <message>
        <source>%1 holes filled</source>
        <translation>填补 %1 个孔洞</translation>
    </message>
    <message>
        <source>the surface is embedded in a cage of %1 vertices, since %2</source>
        <translation>表面嵌入在 %1 个顶点的笼中，因为%2</translation>
    </message>
    <message>
        <source>it cannot be meshed as it is: %1</source>
        <translation>无法按原样划分网格：%1</translation>
    </message>
    <message>
        <source>it has %1 vertices, where %2 were aimed at</source>
        <translation>有 %1 个顶点，而目标为 %2</translation>
    </message>
    <message>
        <source>the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer</source>
        <translation>笼有 %1 个顶点，而目标为 %2：整立方体无法更接近</translation>
    </message>
    <message>
        <source>the cells of the cage are larger than asked for: there is no memory for smaller ones</source>
        <translation>笼的单元大于要求：内存不足以使用更小的单元</translation>
    </message>
    <message>
        <source>sizes are for the exact surface: a cage has cells of one size</source>
        <translation>尺寸仅用于精确表面：笼的单元大小一致</translation>
    </message>
    <message>
        <source>its %1 parts share cells of the cage and move together as %2: smaller cells keep more of them apart</source>
        <translation>其 %1 个部分共用笼的单元，作为 %2 个一起移动：更小的单元可将更多部分分开</translation>
    </message>
    <message>
        <source>the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow</source>
        <translation>笼由 %1 个不相连的块组成：每块需要自己的图钉才能跟随</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie outside the solid that carries them</source>
        <translation>%2 个顶点中有 %1 个位于承载它们的实体之外</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them</source>
        <translation>网格有 %1 个顶点，而目标为 %2：所要求的质量需要它们</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is</source>
        <translation>网格有 %1 个顶点，而目标为 %2：表面保持原样</translation>
    </message>
    <message>
        <source>the surface&apos;s triangles are far larger than the cells inside and are kept as they are, which makes uneven cells</source>
        <translation>表面三角形远大于内部单元且保持原样，导致单元不均匀</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell is above it)</source>
        <translation>最差单元的半径与边长之比为 %1，要求为 %2（%3 个单元超出）</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells are above it)</source>
        <translation>最差单元的半径与边长之比为 %1，要求为 %2（%3 个单元超出）</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2</source>
        <translation>%1：表面保持原样而导致，位于其三角形 %2</translation>
    </message>
    <message>
        <source>%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written without them, so that later vertices have other numbers</source>
        <translation>表面的 %1 个顶点不属于任何四面体：写出的四面体网格不含它们，其后的编号因此不同</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 个顶点不属于任何单元。它们保留在写出的文件中：某些求解器要求先将其去除</translation>
    </message>
    <message>
        <source>parts that touch vertex to vertex are connected: %1 vertices move with others at the same place</source>
        <translation>顶点相接的部分连在一起：%1 个顶点与同处的其他顶点一起移动</translation>
    </message>
    <message>
        <source>a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away unless handles hold it</source>
        <translation>由 %1 组成的部分仅靠 %3 附近的 %2 相连：在那里自由转动的部分可能被甩远，除非用图钉固定</translation>
    </message>
    <message>
        <source>%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 个部分仅靠一个顶点或一条边相连，第一个由 %2 组成，靠 %4 附近的 %3：在那里自由转动的部分可能被甩远，除非用图钉固定</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 个单元</translation>
    </message>
    <message>
        <source>%1 cell</source>
        <translation>%1 个单元</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>the edge %1</source>
        <translation>边 %1</translation>
    </message>
    <message>
        <source>%1 single step</source>
        <translation>%1 个单独步骤</translation>
    </message>
    <message>
        <source>%1 single steps</source>
        <translation>%1 个单独步骤</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>没有三角形 %1</translation>
    </message>
    <message>
        <source>no hole has the edge %1</source>
        <translation>没有孔含有边 %1</translation>
    </message>
    <message>
        <source>the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves together</source>
        <translation>笼体封闭了同一部件内的一处间隙，宽 %1，位于 %2 附近：两侧会一起移动</translation>
    </message>
    <message>
        <source>the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on both sides moves together</source>
        <translation>笼体封闭了同一部件内的 %1 处间隙，最窄的宽 %2，位于 %3 附近：两侧会一起移动</translation>
    </message>
    <message>
        <source>%1; about %2 vertices open the widest</source>
        <translation>%1；约 %2 个顶点可打开最宽的一处</translation>
    </message>
    <message>
        <source>%1; cells of at most %2 open the widest</source>
        <translation>%1；不大于 %2 的单元可打开最宽的一处</translation>
    </message>
    <message>
        <source>%1; a detail of %2 opens the widest</source>
        <translation>%1；细节度 %2 可打开最宽的一处</translation>
    </message>
    <message>
        <source>1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, so that later vertices have other numbers</source>
        <translation>表面有 1 个顶点不属于任何四面体：写出的四面体网格不含它，其后编号随之改变</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell. It stays in what is written: some solvers want it taken out first</source>
        <translation>有 1 个顶点不属于任何单元。写出时会保留：某些求解器要求先将其去除</translation>
    </message>
    <message>
        <source>holds %1 points, but neither triangles nor tetrahedra between them: a surface has to be made of the points first, as MeshLab and CloudCompare do</source>
        <translation>含有 %1 个点，但点之间既没有三角形也没有四面体：请先用 MeshLab 或 CloudCompare 等由这些点生成曲面</translation>
    </message>
    <message>
        <source>%1: its points have four coordinates; only points in space, which have three, are read</source>
        <translation>%1：其点有四个坐标；只能读取有三个坐标的空间点</translation>
    </message>
    <message>
        <source>the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells may help</source>
        <translation>笼子在 %1 秒计算内未完成；减少顶点或增大单元可能有帮助</translation>
    </message>
    <message>
        <source>there is no memory for a cage of so many cells; fewer vertices or larger cells may help</source>
        <translation>内存不足以生成这么多单元的笼子；减少顶点或增大单元可能有帮助</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and about %3 vertices open the widest</source>
        <translation>%1；细节度 %2 加约 %3 个顶点可打开最宽的一处</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and cells of at most %3 open the widest</source>
        <translation>%1；细节度 %2 加不大于 %3 的单元可打开最宽的一处</translation>
    </message>
    <message>
        <source>a list of points without a surface</source>
        <translation>没有表面的点列表</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: its outline needs them</source>
        <translation>网格有 %1 个顶点，而目标为 %2：其轮廓需要这些顶点</translation>
    </message>
    <message>
        <source>is no project of Wend, which is JSON and begins with {</source>
        <translation>不是 Wend 的项目(项目是 JSON,以 { 开头)</translation>
    </message>
    <message>
        <source>has %1 pictures (pages, frames or parts): the first one is read</source>
        <translation>包含 %1 幅图像（页面、帧或部分）：读取第一幅</translation>
    </message>
    <message>
        <source>has channels that are left out: %1</source>
        <translation>有未读取的通道：%1</translation>
    </message>
    <message>
        <source>has a channel of no declared kind after its colours: it is taken as alpha</source>
        <translation>颜色之后有一个未声明类型的通道：将其视为 Alpha</translation>
    </message>
    <message>
        <source>reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off</source>
        <translation>超出了其 %1 x %2 像素的显示窗口：外面的部分被裁掉</translation>
    </message>
    <message>
        <source>has a colour profile that does not fit its colours: it is left out</source>
        <translation>有与其颜色不符的颜色配置文件：已忽略</translation>
    </message>
    <message>
        <source>has a colour space that is not known (cICP %1): it is not kept</source>
        <translation>有未知的色彩空间（cICP %1）：不会保留</translation>
    </message>
    <message>
        <source>1 pixel is not a finite number (NaN or infinity), at x %1, y %2</source>
        <translation>1 个像素不是有限数（NaN 或无穷大），位于 x %1，y %2</translation>
    </message>
    <message>
        <source>%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3</source>
        <translation>%1 个像素不是有限数（NaN 或无穷大），第一个位于 x %2，y %3</translation>
    </message>
    <message>
        <source>is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures</source>
        <translation>是%1。Wend 可打开 PNG、JPEG、TIFF、EXR、WebP、GIF、PSD、OpenRaster、Krita、SVG、HEIC、AVIF、JPEG 2000、相机 RAW 等图像</translation>
    </message>
    <message>
        <source>its reader failed inside (signal %1)</source>
        <translation>读取程序崩溃（信号 %1）</translation>
    </message>
    <message>
        <source>its reader was ended (signal %1)</source>
        <translation>读取程序被终止（信号 %1）</translation>
    </message>
    <message>
        <source>its reader failed (exit code %1)</source>
        <translation>读取程序失败（退出代码 %1）</translation>
    </message>
    <message>
        <source>its reader has done nothing for %1 s</source>
        <translation>读取程序已有 %1 秒没有反应</translation>
    </message>
    <message>
        <source>its reader has not come to an end</source>
        <translation>读取程序未能完成</translation>
    </message>
    <message>
        <source>it needs more than the %1 MB of memory that reading may take</source>
        <translation>所需内存超过读取允许的 %1 MB</translation>
    </message>
    <message>
        <source>has %1 layers: opened flattened</source>
        <translation>有 %1 个图层：已合并打开</translation>
    </message>
    <message>
        <source>holds no picture of all its layers (%1): save it with one</source>
        <translation>不含所有图层的合并图像（%1）：请连同它一起保存</translation>
    </message>
    <message>
        <source>has a damaged %1</source>
        <translation>其中的 %1 已损坏</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and %3 times more</source>
        <translation>在时间 %1，形状在 %2 附近跳到另一个平衡，之后还有 %3 次</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2</source>
        <translation>在时间 %1，形状在 %2 附近跳到另一个平衡</translation>
    </message>
    <message>
        <source>pins of the other project without a namesake here, placed in proportion: %1</source>
        <translation>另一项目中在此没有同名者、已按比例放置的图钉：%1</translation>
    </message>
    <message>
        <source>pins of the other project that find no place here and are left out: %1</source>
        <translation>另一项目中在此没有位置、已略去的图钉：%1</translation>
    </message>
    <message>
        <source>pins without a motion in the other project, which hold still: %1</source>
        <translation>在另一项目中没有动作、保持不动的图钉：%1</translation>
    </message>
    <message>
        <source>moves a solid: its motion does not fit a picture</source>
        <translation>移动的是实体：其动作不适合图片</translation>
    </message>
    <message>
        <source>moves a picture: its motion does not fit a solid</source>
        <translation>移动的是图片：其动作不适合实体</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3</source>
        <translation>壳层层嵌套，最多 %1 层；填充的空间：%2，空心的：%3</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces filled: %2, hollow: %3</source>
        <translation>壳层层嵌套，最多 %1 层，且有物体沿共用的壁相接；填充的空间：%2，空心的：%3</translation>
    </message>
    <message>
        <source>bodies touch along shared walls; spaces filled: %1, hollow: %2</source>
        <translation>有物体沿共用的壁相接；填充的空间：%1，空心的：%2</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled</source>
        <translation>%1 为 %2 × %3 像素，而项目是为 %4 × %5 制作的：图钉和路径已缩放</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where they are</source>
        <translation>%1 为 %2 × %3 像素，而项目是为 %4 × %5 制作的：图钉和路径保持原位</translation>
    </message>
    <message>
        <source>the project&apos;s picture is no SVG drawing: it has no paths that could be written</source>
        <translation>项目的图片不是 SVG 绘图：没有可写出的路径</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is no SVG drawing: it becomes a picture in the SVG file</source>
        <translation>部件“%1”不是 SVG 绘图：在 SVG 文件中成为图片</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is cut: it becomes a picture in the SVG file</source>
        <translation>部件“%1”被裁切：在 SVG 文件中成为图片</translation>
    </message>
    <message>
        <source>its pattern &quot;%1&quot; turns and stretches with each shape, but is not bent</source>
        <translation>其图案“%1”随各形状旋转和拉伸，但不会弯曲</translation>
    </message>
    <message>
        <source>a picture in it stays one</source>
        <translation>其中的图片仍为图片</translation>
    </message>
    <message>
        <source>its picture &quot;%1&quot; is not in the file: it is left out</source>
        <translation>其图片“%1”不在文件中：已略去</translation>
    </message>
    <message>
        <source>its text along a path is left out</source>
        <translation>沿路径的文字已略去</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; is left out</source>
        <translation>其 &lt;%1&gt; 已略去</translation>
    </message>
    <message>
        <source>HDF5 files need wend-hdf5, which is missing beside the program: it is built where libhdf5-dev is installed</source>
        <translation>HDF5 文件需要 wend-hdf5，但程序旁没有它：在安装了 libhdf5-dev 的环境中会构建它</translation>
    </message>
    <message>
        <source>the HDF5 library fails on it: the file may be damaged</source>
        <translation>HDF5 库无法处理它：文件可能已损坏</translation>
    </message>
    <message>
        <source>is no HDF5 file</source>
        <translation>不是 HDF5 文件</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both the same triangles there or leave a gap</source>
        <translation>实体 %1 和 %2 沿三角形不匹配的面相接触（%3 附近）：请让两者在该处使用相同的三角形，或留出间隙</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along an edge or at a point (near %3): give both the same triangles there or leave a gap</source>
        <translation>实体 %1 和 %2 沿边或在一点相接触（%3 附近）：请让两者在该处使用相同的三角形，或留出间隙</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell; it lies at the place of another and moves with it. It stays in what is written: some solvers want it taken out first</source>
        <translation>有 1 个顶点不属于任何单元；它与另一顶点重合并随之移动。写出时会保留：某些求解器要求先将其去除</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell; %2 of them lie at the place of another and move with it. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 个顶点不属于任何单元；其中 %2 个与另一顶点重合并随之移动。它们保留在写出的文件中：某些求解器要求先将其去除</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more</source>
        <translation>%1：表面保持原样而导致，位于其三角形 %2 及另外 %3 个</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; has the blend mode %2: it is shown as normal</source>
        <translation>图层“%1”的混合模式为 %2：按正常显示</translation>
    </message>
    <message>
        <source>1 hole of %1 edges stayed open, larger than the limit of %2</source>
        <translation>1 个 %1 条边的孔洞仍然敞开，超过上限 %2</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 edges stayed open, larger than the limit of %3</source>
        <translation>%1 个最多 %2 条边的孔洞仍然敞开，超过上限 %3</translation>
    </message>
    <message>
        <source>1 vertex of open seams welded, the widest gap %1</source>
        <translation>焊接开放接缝的 1 个顶点，最宽间隙 %1</translation>
    </message>
    <message>
        <source>%1 vertices of open seams welded, the widest gap %2</source>
        <translation>焊接开放接缝的 %1 个顶点，最宽间隙 %2</translation>
    </message>
    <message>
        <source> (after the repair: %1)</source>
        <translation>（修复后：%1）</translation>
    </message>
    <message>
        <source>; the repair found nothing that it could repair</source>
        <translation>；修复未找到可修复之处</translation>
    </message>
    <message>
        <source>%1 and %2 move the joint at %3 in different ways at time %4</source>
        <translation>%1 和 %2 在时刻 %4 以不同方式移动 %3 处的关节</translation>
    </message>
    <message>
        <source>the multigrid solver did not find the velocities near %1; solve directly (--solver direct), or make the material or the mesh more even</source>
        <translation>多重网格求解器未能求得 %1 附近的速度；请直接求解（--solver direct），或使材料或网格更均匀</translation>
    </message>
    <message>
        <source>%1: its points have any number of coordinates; only points in space, which have three, are read</source>
        <translation>%1：其点的坐标数任意；只能读取有三个坐标的空间点</translation>
    </message>
    <message>
        <source>%1 vertex that is not finite (first: %2)</source>
        <translation>%1 个非有限的顶点（%2）</translation>
    </message>
    <message>
        <source>%1 vertices that are not finite (first: %2)</source>
        <translation>%1 个非有限的顶点（首个：%2）</translation>
    </message>
    <message>
        <source>%1 triangle that names a missing vertex (first: %2)</source>
        <translation>%1 个引用不存在顶点的三角形（%2）</translation>
    </message>
    <message>
        <source>%1 triangles that name a missing vertex (first: %2)</source>
        <translation>%1 个引用不存在顶点的三角形（首个：%2）</translation>
    </message>
    <message>
        <source>an IFF file</source>
        <translation>IFF 文件</translation>
    </message>
    <message>
        <source>a KTX texture</source>
        <translation>KTX 纹理</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>PostScript 文档</translation>
    </message>
    <message>
        <source>a PAM picture</source>
        <translation>PAM 图片</translation>
    </message>
    <message>
        <source>a Windows cursor</source>
        <translation>Windows 光标</translation>
    </message>
    <message>
        <source>a QOI picture</source>
        <translation>QOI 图片</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 2 GB, these layers have more</source>
        <translation>无法写入：Photoshop 文件最大为 2 GB，而这些图层更大</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 30000 pixels a side</source>
        <translation>无法写入：Photoshop 文件每边最多 30000 像素</translation>
    </message>
    <message>
        <source>the shape is too stiff to settle further near %1: the steps would be too short; allow a larger tolerance</source>
        <translation>形状在 %1 附近过于坚硬，无法继续松弛：步长会过短；请放宽容差</translation>
    </message>
    <message>
        <source>%1 cannot go on: %2</source>
        <translation>%1 无法继续：%2</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and once more</source>
        <translation>在时间 %1，形状在 %2 附近跳到另一个平衡，之后还有一次</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2</source>
        <translation>在 %1 秒处，形状在 %2 附近跳到另一个姿势</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and once more</source>
        <translation>在 %1 秒处，形状在 %2 附近跳到另一个姿势，之后还有一次</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and %3 times more</source>
        <translation>在 %1 秒处，形状在 %2 附近跳到另一个姿势，之后还有 %3 次</translation>
    </message>
</context>
<context>
    <name>CropTool</name>
    <message>
        <source>Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the proportions, Delete or a double-click removes it</source>
        <translation>拖出矩形框住导出要保留的部分；可拖动其内部或各边；Shift 保持比例，Delete 键或双击将其移除</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Double-click to insert a point into the curve</source>
        <translation>双击曲线可插入点</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>更改曲线</translation>
    </message>
    <message>
        <source>Insert curve point</source>
        <translation>插入曲线点</translation>
    </message>
    <message>
        <source>Delete curve point</source>
        <translation>删除曲线点</translation>
    </message>
    <message>
        <source>The ends of a curve must stay.</source>
        <translation>曲线的端点不能删除。</translation>
    </message>
    <message>
        <source>Drag the curve&apos;s point, Shift keeps it straight, Ctrl moves one direction only; Delete removes it, a right-click shows more</source>
        <translation>拖动曲线上的点，按住 Shift 走直线，按住 Ctrl 只动一侧方向；按 Delete 删除，右键单击显示更多</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Drag the arrow to move the cut, the rings to tilt it; Esc puts it back</source>
        <translation>拖动箭头移动剖切面，拖动圆环使其倾斜；按 Esc 复原</translation>
    </message>
</context>
<context>
    <name>DepthTool</name>
    <message>
        <source>Brush over what lies in front or behind; Ctrl clears it, Shift swaps front and back, [ and ] change the size</source>
        <translation>用画笔刷过位于前面或后面的部分；按住 Ctrl 清除，按住 Shift 前后互换，[ 和 ] 更改大小</translation>
    </message>
    <message>
        <source>Paint in front</source>
        <translation>绘制到前面</translation>
    </message>
    <message>
        <source>Paint behind</source>
        <translation>绘制到后面</translation>
    </message>
    <message>
        <source>Clear depth</source>
        <translation>清除深度</translation>
    </message>
</context>
<context>
    <name>EaseNames</name>
    <message>
        <source>Ease &amp;In</source>
        <translation>缓入(&amp;I)</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>缓出(&amp;O)</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>缓入缓出(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>线性(&amp;L)</translation>
    </message>
</context>
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Nothing grows or shrinks. Parts may get thin.</source>
        <translation>不胀不缩。局部可能变细。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Stretches least. Start here.</source>
        <translation>拉伸最小。建议从这里开始。</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>刚性</translation>
    </message>
    <message>
        <source>Parts turn like card.</source>
        <translation>各部分像硬纸板一样转动。</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Details keep their look. Parts may swell.</source>
        <translation>细节保持原样。局部可能膨胀。</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
</context>
<context>
    <name>ExportFormats</name>
    <message>
        <source>Layers (OpenRaster)</source>
        <translation>图层 (OpenRaster)</translation>
    </message>
    <message>
        <source>This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). Animated WebP needs no other program.</source>
        <translation>此影片由程序 ffmpeg 生成，但尚未安装（Debian：sudo apt install ffmpeg）。动画 WebP 不需要其他程序。</translation>
    </message>
    <message>
        <source>glTF film</source>
        <translation>glTF 影片</translation>
    </message>
    <message>
        <source>Spine skeleton</source>
        <translation>Spine 骨架</translation>
    </message>
    <message>
        <source>DragonBones skeleton</source>
        <translation>DragonBones 骨架</translation>
    </message>
    <message>
        <source>Layers (Photoshop)</source>
        <translation>图层 (Photoshop)</translation>
    </message>
</context>
<context>
    <name>FileCard</name>
    <message>
        <source>Eyes stay round</source>
        <translation>眼睛始终是圆的</translation>
    </message>
    <message>
        <source>Pins and paths</source>
        <translation>图钉与路径</translation>
    </message>
    <message>
        <source>Many pins at once</source>
        <translation>同时使用多个图钉</translation>
    </message>
    <message>
        <source>Flight, with a skin</source>
        <translation>飞翔，带蒙皮</translation>
    </message>
    <message>
        <source>A stiff middle</source>
        <translation>坚硬的中段</translation>
    </message>
    <message>
        <source>Frog</source>
        <translation>青蛙</translation>
    </message>
    <message>
        <source>Giraffe</source>
        <translation>长颈鹿</translation>
    </message>
    <message>
        <source>Octopus</source>
        <translation>章鱼</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>长条</translation>
    </message>
    <message>
        <source>Eagle</source>
        <translation>鹰</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>方条</translation>
    </message>
    <message>
        <source>Choose what to keep</source>
        <translation>选择要保持的内容</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>行走者</translation>
    </message>
    <message>
        <source>A walk that loops</source>
        <translation>循环行走</translation>
    </message>
</context>
<context>
    <name>FillTool</name>
    <message>
        <source>Click to pick up what is painted there</source>
        <translation>单击以吸取该处绘制的内容</translation>
    </message>
    <message>
        <source>Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up</source>
        <translation>单击以填充相连的部分；按住 Shift 全部填充，按住 Ctrl 擦除绘制，按住 Alt 吸取</translation>
    </message>
    <message>
        <source>Fill with %1</source>
        <translation>用“%1”填充</translation>
    </message>
</context>
<context>
    <name>GrabTool</name>
    <message>
        <source>Draw around the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>圈出要抓取的部位；按住 Shift 添加到所选部位，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>用画笔刷过要抓取的部位，[ 和 ] 更改大小；按住 Shift 添加，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>用矩形框住要抓取的部位；按住 Shift 添加到所选部位，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>部位</translation>
    </message>
    <message>
        <source>No part of the shape lies in this outline.</source>
        <translation>此轮廓内没有形状。</translation>
    </message>
    <message>
        <source>Select one part to take away from.</source>
        <translation>请选择一个要从中减去的部位。</translation>
    </message>
    <message>
        <source>A handle must hold something; Delete removes it.</source>
        <translation>手柄不能为空：要移除它，请按 Delete 键。</translation>
    </message>
</context>
<context>
    <name>GradientTool</name>
    <message>
        <source>Move gradient</source>
        <translation>移动渐变</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>渐变到%1</translation>
    </message>
    <message>
        <source>Blend to %1</source>
        <translation>渐变到“%1”</translation>
    </message>
    <message>
        <source>Drag over the shape to blend evenly from what is there to what is chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels</source>
        <translation>在形状上拖动：从原有内容均匀过渡到右侧所选内容；按住 Shift 以 45° 为步长，按住 Alt 吸取，按 Esc 放弃</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Stretch</source>
        <translation>拉伸</translation>
    </message>
    <message>
        <source>stretch %1</source>
        <translation>拉伸 %1</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>area ×%1</source>
        <translation>面积 ×%1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>volume ×%1</source>
        <translation>体积 ×%1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>angle error %1</source>
        <translation>角度误差 %1</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>单元尺寸</translation>
    </message>
    <message>
        <source>Distance from rest</source>
        <translation>与变形前的距离</translation>
    </message>
    <message>
        <source>Influence of the pin</source>
        <translation>图钉的影响</translation>
    </message>
    <message>
        <source>Stretched too far here · %1</source>
        <translation>此处拉伸过度 · %1</translation>
    </message>
    <message>
        <source>Grown too far here · %1</source>
        <translation>此处放大过度 · %1</translation>
    </message>
    <message>
        <source>Shrunk too far here · %1</source>
        <translation>此处缩小过度 · %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>缩放雅可比</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>长宽比</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>最小角</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>最小二面角</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears</source>
        <translation>单击两点测长度，第三点测角度；按住 Ctrl 取顶点，按 Esc 清除</translation>
    </message>
    <message>
        <source>angle %1, at rest %2</source>
        <translation>角度 %1（变形前 %2）</translation>
    </message>
    <message>
        <source>length %1, at rest %2</source>
        <translation>长度 %1（变形前 %2）</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>Det&amp;ail, in vertices</source>
        <translation>精细度（顶点数）(&amp;A)</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点数</translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation>网格的精细程度。顶点越多，变形越平滑，耗时也越长。</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>更改精细度</translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation>轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>更改轮廓</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>整张图片</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>抠图</translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation>手绘多边形</translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation>比此值更不透明的像素属于形状。</translation>
    </message>
    <message>
        <source>Change what counts as solid</source>
        <translation>更改不透明的下限</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>边距(&amp;R)</translation>
    </message>
    <message>
        <source>The outline grows by this much, so that soft edges are kept whole.</source>
        <translation>轮廓向外扩展的宽度，使柔和的边缘也能完整地随之变形。</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>更改边距</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>图片边缘(&amp;B)</translation>
    </message>
    <message>
        <source>Picture&apos;s border</source>
        <translation>图片边缘</translation>
    </message>
    <message>
        <source>Holds the frame of a photograph, so that no gap opens at its edge: it stays where it is, or its sides slide along themselves. Pins on it still move.</source>
        <translation>固定照片的边框，避免旁边出现空隙：边框停在原处，或各边沿边线滑动。边框上的图钉仍可移动。</translation>
    </message>
    <message>
        <source>Hold the border</source>
        <translation>固定图片边缘</translation>
    </message>
    <message>
        <source>Moves freely</source>
        <translation>自由移动</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>停在原处</translation>
    </message>
    <message>
        <source>Slides along itself</source>
        <translation>沿边线滑动</translation>
    </message>
    <message>
        <source>Radius–edge rati&amp;o</source>
        <translation>半径边长比(&amp;O)</translation>
    </message>
    <message>
        <source>How flat the tetrahedra may be: the maximum ratio of circumradius to shortest edge. Smaller is rounder and takes more of them.</source>
        <translation>四面体允许的扁平程度：外接球半径与最短边之比的最大值。越小越圆整，所需四面体也越多。</translation>
    </message>
    <message>
        <source>Change radius–edge ratio</source>
        <translation>更改半径边长比</translation>
    </message>
    <message>
        <source>Ma&amp;ximum volume</source>
        <translation>最大体积(&amp;G)</translation>
    </message>
    <message>
        <source>Larger tetrahedra are split; in the file&apos;s units, cubed. Half the volume makes about twice as many. At a surface that is kept, some may stay larger.</source>
        <translation>更大的四面体会被分割；以文件单位的立方计。减半则数量约增一倍。若保留表面，表面附近可能仍有较大的四面体。</translation>
    </message>
    <message>
        <source>Change maximum volume</source>
        <translation>更改最大体积</translation>
    </message>
    <message>
        <source>Refine s&amp;urface</source>
        <translation>细分表面(&amp;U)</translation>
    </message>
    <message>
        <source>Allows the surface&apos;s triangles to be split where they are larger than the tetrahedra inside. If off, the surface is kept exactly as it is.</source>
        <translation>表面三角形大于内部四面体时允许分割。关闭时，表面完全保持原样。</translation>
    </message>
    <message>
        <source>Refine surface</source>
        <translation>细分表面</translation>
    </message>
    <message>
        <source>Fill holes up to (edges)</source>
        <translation>补洞上限（边数）</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>最大孔洞</translation>
    </message>
    <message>
        <source>“Repair” fills holes of at most this many edges.</source>
        <translation>“修复”填补边数不超过此值的孔洞。</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>填充方式(&amp;I)</translation>
    </message>
    <message>
        <source>What is filled: the surface itself, or a cage of even cells around it, in which it is embedded. Automatic takes the cage where the surface cannot be filled or has far too many vertices.</source>
        <translation>填充的对象：表面本身，或包围它的均匀单元笼体，表面随笼体变形。“自动”在表面无法填充或顶点过多时采用笼体。</translation>
    </message>
    <message>
        <source>Change fit</source>
        <translation>更改填充方式</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Exact surface</source>
        <translation>精确表面</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>笼体</translation>
    </message>
    <message>
        <source>Exact &amp;balance</source>
        <translation>平衡值(&amp;B)</translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation>更改能量</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
    <message>
        <source>Smoothi&amp;ng length</source>
        <translation>平滑长度(&amp;N)</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads, as a fraction of the shape&apos;s size. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation>图钉拉力的扩散范围，以形状大小的比例表示。小：集中在图钉附近，较尖锐。大：柔和而宽广。</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>更改平滑</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>number of frames, evenly spaced from the start to the last time</source>
        <translation>从开始到最后时刻等间隔的帧数</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>帧数(&amp;R)</translation>
    </message>
    <message>
        <source>whether distortion, φ, directions and velocity are written with meshes, in formats that carry values</source>
        <translation>在支持附加数值的格式中，网格是否附带畸变、φ、方向和速度</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>数值(&amp;V)</translation>
    </message>
    <message>
        <source>Errors, material, velocity</source>
        <translation>误差、材料、速度</translation>
    </message>
    <message>
        <source>The shape alone</source>
        <translation>仅形状</translation>
    </message>
    <message>
        <source>how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)</source>
        <translation>支持多种编码的网格文件（ply、stl、msh、vtk、vtu）中数值的编码方式</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>数值编码(&amp;N)</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>二进制</translation>
    </message>
    <message>
        <source>Binary, compressed</source>
        <translation>二进制（压缩）</translation>
    </message>
    <message>
        <source>version of .msh files</source>
        <translation>.msh 文件的版本</translation>
    </message>
    <message>
        <source>&amp;Gmsh version</source>
        <translation>Gmsh 版本(&amp;G)</translation>
    </message>
    <message>
        <source>write the triangles of a solid&apos;s border as cells too, with the values of the tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless the input had such triangles</source>
        <translation>将实体边界的三角形也作为单元写入，并带上其后方四面体的数值；关闭时 .vtu 和 .vtk 仅含四面体，除非原文件已有这样的三角形</translation>
    </message>
    <message>
        <source>&amp;Border triangles</source>
        <translation>边界三角形(&amp;B)</translation>
    </message>
    <message>
        <source>how the picture is sampled</source>
        <translation>图片的采样方式</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>插值(&amp;T)</translation>
    </message>
    <message>
        <source>Nearest – hard pixels</source>
        <translation>最近邻 – 硬像素</translation>
    </message>
    <message>
        <source>Bilinear – quick</source>
        <translation>双线性 – 快速</translation>
    </message>
    <message>
        <source>Bicubic – sharp</source>
        <translation>双三次 – 锐利</translation>
    </message>
    <message>
        <source>EWA – best</source>
        <translation>EWA – 最佳</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>画布(&amp;C)</translation>
    </message>
    <message>
        <source>As large as the picture</source>
        <translation>与图片一样大</translation>
    </message>
    <message>
        <source>Fit to the shape</source>
        <translation>适合形状</translation>
    </message>
    <message>
        <source>bits per channel in pictures: as in the source, 8 or 16, or half or full floating point; values stay what they are</source>
        <translation>图片每通道的位数：与原图相同、8、16，或半精度、单精度浮点数；数值保持不变</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>位深度(&amp;D)</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>与图片相同</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 位</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 位</translation>
    </message>
    <message>
        <source>16 bit floating point (half)</source>
        <translation>16 位浮点（half）</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 位浮点</translation>
    </message>
    <message>
        <source>what pictures show around the shape: nothing, its border drawn outwards, the source as it was, or a colour</source>
        <translation>形状以外显示的内容：无、延伸的边缘、原图，或一种颜色</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>背景(&amp;B)</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>The border, drawn outwards</source>
        <translation>延伸边缘</translation>
    </message>
    <message>
        <source>The picture as it was</source>
        <translation>原图</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黑色</translation>
    </message>
    <message>
        <source>How far apart growing the outline keeps parts and limbs, so that they do not become one.</source>
        <translation>扩展时各部分与肢体之间保持这么远，以免连成一体。</translation>
    </message>
    <message>
        <source>Change gap</source>
        <translation>更改间隙</translation>
    </message>
    <message>
        <source>Parts and holes of fewer pixels, such as dust around a drawing, are left out.</source>
        <translation>像素更少的部分和孔洞（例如图画周围的灰尘）会被忽略。</translation>
    </message>
    <message>
        <source>Change what is left out</source>
        <translation>更改忽略的内容</translation>
    </message>
    <message>
        <source>&amp;Gap</source>
        <translation>间隙(&amp;G)</translation>
    </message>
    <message>
        <source>Drop &amp;below</source>
        <translation>忽略小于(&amp;B)</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>更改向上的轴</translation>
    </message>
    <message>
        <source>pixels that pictures show: those of the source, as many as the shape needs, or those of a rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it</source>
        <translation>图片显示的像素：与源图相同、按形状所需，或源图的矩形 X,Y,宽,高（可超出源图）</translation>
    </message>
    <message>
        <source>Another colour …</source>
        <translation>其他颜色…</translation>
    </message>
    <message>
        <source>R&amp;ate</source>
        <translation>帧速率(&amp;S)</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>whether WebP pictures and films keep every pixel, or are a fraction of the size with hardly visible losses</source>
        <translation>WebP 图片和影片是保留每个像素，还是以几乎看不出的损失换取小得多的文件</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>质量(&amp;Q)</translation>
    </message>
    <message>
        <source>Every pixel – lossless</source>
        <translation>每个像素 – 无损</translation>
    </message>
    <message>
        <source>Smaller file – lossy</source>
        <translation>更小的文件 – 有损</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>回弹</translation>
    </message>
    <message>
        <source>Lead a pin around and back: how far does the shape come back, too? Not at all: where it ends depends on the path. Fully: it is as it was.</source>
        <translation>图钉绕一圈回到原处时，形状会恢复多少？无：最终形状取决于路径。完全：恢复原样。</translation>
    </message>
    <message>
        <source>Change springing back</source>
        <translation>更改回弹</translation>
    </message>
    <message>
        <source>Opa&amp;que from</source>
        <translation>不透明起点(&amp;Q)</translation>
    </message>
    <message>
        <source>Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid).</source>
        <translation>以数值 φ 表示的“保持”，与项目文件中相同：0.002 保持面积或体积，0.464 保持长度，1.571 为刚性，2.678 保持角度（实体为 2.498）。</translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, this with what its lines enclose, or the picture as a whole.</source>
        <translation>弯曲的范围：仅图像中不透明的部分、该部分及其线条所围的内部，或整幅图像。</translation>
    </message>
    <message>
        <source>Cut-out, holes filled</source>
        <translation>抠图，填充孔洞</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>更改求解器</translation>
    </message>
    <message>
        <source>frames per second of a film; a unit of time is a second</source>
        <translation>影片每秒的帧数；一个时间单位是一秒</translation>
    </message>
    <message>
        <source>Change frame rate</source>
        <translation>更改帧率</translation>
    </message>
    <message>
        <source>leave the last frame out, which is the first one again: for films that repeat; if the project has a cycle, show that</source>
        <translation>省去与第一帧相同的最后一帧：用于重复播放的影片；如果项目有循环段，则显示该段</translation>
    </message>
    <message>
        <source>Loop: no fra&amp;me twice</source>
        <translation>循环：没有重复的帧(&amp;M)</translation>
    </message>
    <message>
        <source>size of pictures in percent of the canvas; that of frames becomes even</source>
        <translation>图片大小占画布的百分比；帧的大小会变为偶数</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>大小(&amp;S)</translation>
    </message>
    <message>
        <source>width of pictures, instead of a size in percent</source>
        <translation>图片宽度，代替百分比大小</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Inner she&amp;lls</source>
        <translation>内部的壳(&amp;L)</translation>
    </message>
    <message>
        <source>What is inside of shells that lie one in the other: holes, or regions of their own, whose cells are labelled. Bodies that share walls are all filled and labelled.</source>
        <translation>嵌套的壳内部是什么：孔洞，或各自的区域，其单元带有标签。共用壁的物体都会被填充并加上标签。</translation>
    </message>
    <message>
        <source>Change inner shells</source>
        <translation>更改内部的壳</translation>
    </message>
    <message>
        <source>Holes, and say so</source>
        <translation>孔洞，并提示</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>区域</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>Draw around what should bend, too; Ctrl takes it away, Esc cancels</source>
        <translation>圈出也要变形的部分；按住 Ctrl 减去。按 Esc 放弃</translation>
    </message>
    <message>
        <source>Brush over what should bend, too; Ctrl takes it away, [ and ] change the size</source>
        <translation>用画笔刷过也要变形的部分，[ 和 ] 更改大小；按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Click a colour that should bend, too; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>单击也要变形的颜色；按住 Ctrl 减去，[ 和 ] 缩小或扩大颜色范围</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape; Esc cancels</source>
        <translation>画一条线，形状沿此线切开；按 Esc 放弃</translation>
    </message>
    <message>
        <source>Nothing would be left of the shape.</source>
        <translation>这样形状将什么都不剩。</translation>
    </message>
    <message numerus="yes">
        <source>Pins outside the new outline were removed: %n.</source>
        <translation>
            <numerusform>%n 个图钉位于新轮廓之外，已移除。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切开</translation>
    </message>
    <message>
        <source>Take away from the outline</source>
        <translation>从轮廓减去</translation>
    </message>
    <message>
        <source>Add to the outline</source>
        <translation>添加到轮廓</translation>
    </message>
    <message>
        <source>The tolerance, or [ and ], changes what was taken; click another colour to take it too, with Ctrl to take it away</source>
        <translation>容差（也可用 [ 和 ]）会改变已选取的范围；单击其他颜色可添加，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>That was a line. Draw around a part of the picture.</source>
        <translation>那是一条线。请圈出图像的一部分。</translation>
    </message>
    <message>
        <source>From now on the outline is as you draw it, and has no margin to change. Choose “Cut-out” as the outline to go back to the one that was found.</source>
        <translation>从现在起轮廓以您所画为准，没有可调的边距。将轮廓设为“抠图”可恢复自动找到的轮廓。</translation>
    </message>
    <message>
        <source>Draw around what should bend; Ctrl takes it away, Esc cancels</source>
        <translation>圈出要变形的部分；按住 Ctrl 减去。按 Esc 放弃</translation>
    </message>
    <message>
        <source>Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl takes away, Backspace removes the last corner, Esc cancels</source>
        <translation>逐个单击角点，按住 Shift 以 45° 为步长，双击闭合；按住 Ctrl 减去，按 Backspace 退回一个角点，按 Esc 放弃</translation>
    </message>
    <message>
        <source>Brush over what should bend; Ctrl takes it away, [ and ] change the size</source>
        <translation>用画笔刷过要变形的部分，[ 和 ] 更改大小；按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Click a colour that should bend; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>单击要变形的颜色；按住 Ctrl 减去，[ 和 ] 缩小或扩大颜色范围</translation>
    </message>
    <message>
        <source>Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels</source>
        <translation>圈出要成为独立部件的区域，直到与其余部分相连处；Esc 取消</translation>
    </message>
    <message>
        <source>This picture has parts: choose the one in the list that this outline is for, or Make a Part to cut another one out.</source>
        <translation>此图片有部件：请在列表中选择此轮廓所属的部件，或选择“制作部件”再剪出一个。</translation>
    </message>
    <message>
        <source>“%1” is locked. The list of parts unlocks it.</source>
        <translation>“%1”已锁定。可在部件列表中解锁。</translation>
    </message>
</context>
<context>
    <name>PaintTool</name>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>刚性</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Combed</source>
        <translation>梳理</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>已平滑</translation>
    </message>
    <message>
        <source>Erase paint from %1</source>
        <translation>擦除 %1 上的绘制</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>平滑 %1</translation>
    </message>
    <message>
        <source>Comb %1</source>
        <translation>梳理 %1</translation>
    </message>
    <message>
        <source>Paint %1 on %2</source>
        <translation>在 %2 上绘制“%1”</translation>
    </message>
    <message>
        <source>There is no direction to follow: the numbers on the right were used.</source>
        <translation>没有可循的方向：已采用右侧的数值。</translation>
    </message>
    <message>
        <source>Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>沿要加强刚度的方向梳理；按住 Ctrl 去除，按住 Shift 平滑，按住 Shift 单击画直线，按住 Alt 单击吸取，按 Esc 放弃笔画</translation>
    </message>
    <message>
        <source>Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>绘制右侧所选内容；按住 Ctrl 去除，按住 Shift 平滑，按住 Shift 单击画直线，按住 Alt 单击吸取，按 Esc 放弃笔画</translation>
    </message>
    <message>
        <source>Stiffness ×1 is the same as everywhere and changes nothing: choose on the right how many times stiffer it should be</source>
        <translation>刚度 ×1 与别处相同，在此不会改变任何内容：请在右侧选择刚度的倍数</translation>
    </message>
    <message>
        <source>Erase paint</source>
        <translation>擦除绘制</translation>
    </message>
    <message>
        <source>Erases paint from all visible layers: brush over what should be like the rest again; Shift-click draws a line, Esc cancels the stroke</source>
        <translation>擦除所有可见图层上的绘制：用画笔刷过要恢复为与别处相同的部分；Shift+单击画直线，按 Esc 放弃这一笔</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>梳理</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>绘制“%1”</translation>
    </message>
    <message>
        <source>Nothing is painted there</source>
        <translation>那里没有绘制任何内容</translation>
    </message>
</context>
<context>
    <name>PanTool</name>
    <message>
        <source>Drag to move the view; the wheel zooms</source>
        <translation>拖动可移动视图；滚轮缩放</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>There is nothing of the picture in this area.</source>
        <translation>此区域内没有图像内容。</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>部件 %1</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>制作部件</translation>
    </message>
    <message>
        <source>“%1” is a part now, joined to “%2” where it hangs on it. What is behind it is being filled.</source>
        <translation>“%1”现在是一个部件，在相连处与“%2”连接。正在填充其后方。</translation>
    </message>
    <message>
        <source>“%1” is a part now, cut from “%2”. What is behind it is being filled. Pin it, or join it under Parts.</source>
        <translation>“%1”现在是一个部件，裁自“%2”。正在填充其后方。请固定它，或在“部件”中连接。</translation>
    </message>
    <message>
        <source>In this area is nothing but what is locked, if anything. The list of parts unlocks it.</source>
        <translation>此区域内最多只有已锁定的内容。可在部件列表中解锁。</translation>
    </message>
    <message>
        <source>The parts are still being made. Another one can be made as soon as they are there.</source>
        <translation>部件仍在制作中。完成后即可制作另一个部件。</translation>
    </message>
</context>
<context>
    <name>PenTool</name>
    <message>
        <source>Click the pin whose path you want to draw</source>
        <translation>单击要绘制路径的图钉</translation>
    </message>
    <message>
        <source>Click where the selected pin should go, point by point; drag for a smooth point</source>
        <translation>逐点单击所选图钉要去的位置；拖动添加平滑点</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, Shift snaps to 45°; Enter ends, Backspace removes the last point, Esc cancels</source>
        <translation>单击得到拐角，拖动得到平滑点，Shift 以 45° 为步长；Enter 结束，Backspace 退回一点，Esc 放弃</translation>
    </message>
    <message>
        <source>Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only</source>
        <translation>拖动成为平滑点：Shift 对齐到 45°，Ctrl 或 Alt 只移动这一侧</translation>
    </message>
</context>
<context>
    <name>PictureTip</name>
    <message>
        <source>near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>×1 everywhere</source>
        <translation>处处 ×1</translation>
    </message>
    <message>
        <source>×50 along the left half</source>
        <translation>沿左半部分 ×50</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>无</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>完全</translation>
    </message>
    <message>
        <source>as it was pulled</source>
        <translation>拉动后</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>松弛后</translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag as far as the pin should hold; Esc cancels</source>
        <translation>拖动到图钉要抓取的范围；按 Esc 放弃</translation>
    </message>
    <message>
        <source>Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number</source>
        <translation>拖动圆点旋转，按住 Shift 以 15° 为步长；拖动方块缩放；可键入数值</translation>
    </message>
    <message>
        <source>%1: holds from %2 s</source>
        <translation>%1：从 %2 秒起固定</translation>
    </message>
    <message>
        <source>%1: released at %2 s</source>
        <translation>%1：在 %2 秒松开</translation>
    </message>
    <message>
        <source>Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl records it; digits set the number</source>
        <translation>在任意处拖动可旋转所选内容，Shift 每次 15°，Ctrl 录制；输入数字可设定数值</translation>
    </message>
    <message>
        <source>Drag anywhere to scale what is selected, Ctrl records it; digits set the number</source>
        <translation>在任意处拖动可缩放所选内容，Ctrl 录制；输入数字可设定数值</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; G moves, R rotates, S scales</source>
        <translation>拖动箭头、方块或圆环；G 移动，R 旋转，S 缩放</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, draw around pins to select them</source>
        <translation>在形状上单击放置图钉，拖动立即变形；在形状外圈住图钉进行选择</translation>
    </message>
    <message>
        <source>Draw around pins to select them; Shift adds, Ctrl takes away</source>
        <translation>圈住图钉进行选择；按住 Shift 添加，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, brush over pins, [ and ] change the size</source>
        <translation>在形状上单击放置图钉，拖动立即变形；在形状外用画笔刷过图钉，[ 和 ] 更改大小</translation>
    </message>
    <message>
        <source>Brush over pins to select them, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>用画笔刷过图钉进行选择，[ 和 ] 更改大小；按住 Shift 添加，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, or press and drag to bend it at once</source>
        <translation>在形状上单击放置图钉，或按住并拖动立即使其变形</translation>
    </message>
    <message>
        <source>Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move</source>
        <translation>单击，或在图钉旁拉框进行选择；按住 Shift 添加，按住 Ctrl 减去；拖动或用方向键移动</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y, Z lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>按住 Shift 走直线；按 X、Y、Z 锁定轴，键入数值设定量，按 Esc 复原形状</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>按住 Shift 走直线；按 X、Y 锁定轴，键入数值设定量，按 Esc 复原形状</translation>
    </message>
    <message>
        <source>Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, Shift-click to select more</source>
        <translation>拖动移动图钉，Ctrl 拖动录制，Ctrl+Shift 拖动加宽，Shift 单击选择更多</translation>
    </message>
    <message>
        <source>Drag to scale: the point becomes a small circle</source>
        <translation>拖动缩放：点变为小圆</translation>
    </message>
    <message>
        <source>Drag to rotate: the point becomes a small circle, which holds its angle</source>
        <translation>拖动旋转：点变为保持角度的小圆</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>Choose one in the list first.</source>
        <translation>请先在列表中选择一项。</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Recording until you let go; Esc cancels</source>
        <translation>松开之前的动作会原样录制；按 Esc 放弃</translation>
    </message>
</context>
<context>
    <name>RegionTool</name>
    <message>
        <source>Drag from a point on the surface to hold a ball; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>从表面上一点拖动，以球体抓取；按住 Shift 将其中内容添加到所选手柄，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>Drag from a point on the surface towards the side to hold: all that lies beyond the point</source>
        <translation>从表面上一点朝要抓取的一侧拖动：该点以外的部分全部抓取</translation>
    </message>
    <message>
        <source>Drag from a point on the surface to hold a box; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>从表面上一点拖动，以长方体抓取；按住 Shift 将其中内容添加到所选手柄，按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>There is no vertex in this region.</source>
        <translation>此区域中没有顶点。</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
</context>
<context>
    <name>SampleNames</name>
    <message>
        <source>back</source>
        <translation>背部</translation>
    </message>
    <message>
        <source>body</source>
        <translation>身体</translation>
    </message>
    <message>
        <source>face</source>
        <translation>脸</translation>
    </message>
    <message>
        <source>far front hoof</source>
        <translation>远侧前蹄</translation>
    </message>
    <message>
        <source>far hind hoof</source>
        <translation>远侧后蹄</translation>
    </message>
    <message>
        <source>front hoof</source>
        <translation>前蹄</translation>
    </message>
    <message>
        <source>head</source>
        <translation>头</translation>
    </message>
    <message>
        <source>hind hoof</source>
        <translation>后蹄</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>左肘</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>左眼</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左脚</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>左下腕</translation>
    </message>
    <message>
        <source>left middle arm</source>
        <translation>左中腕</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>左上腕</translation>
    </message>
    <message>
        <source>left wing</source>
        <translation>左翼</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>右眼</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右脚</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>右下腕</translation>
    </message>
    <message>
        <source>right middle arm</source>
        <translation>右中腕</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>右上腕</translation>
    </message>
    <message>
        <source>right wing</source>
        <translation>右翼</translation>
    </message>
    <message>
        <source>rump</source>
        <translation>臀部</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>肩</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>坚硬</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>尾巴</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸部</translation>
    </message>
    <message>
        <source>far hand</source>
        <translation>远侧手</translation>
    </message>
    <message>
        <source>far heel</source>
        <translation>远侧脚跟</translation>
    </message>
    <message>
        <source>far toe</source>
        <translation>远侧脚尖</translation>
    </message>
    <message>
        <source>near hand</source>
        <translation>近侧手</translation>
    </message>
    <message>
        <source>near heel</source>
        <translation>近侧脚跟</translation>
    </message>
    <message>
        <source>near toe</source>
        <translation>近侧脚尖</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>影子</translation>
    </message>
</context>
<context>
    <name>SizeTool</name>
    <message>
        <source>Brush over what should be meshed finer; Shift makes it coarser, Ctrl evens it out again, [ and ] change the size</source>
        <translation>用画笔刷过网格要更细的部分；按住 Shift 变粗，按住 Ctrl 恢复均匀，[ 和 ] 更改大小</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>网格来自文件，按原样使用。</translation>
    </message>
    <message>
        <source>Paint finer mesh</source>
        <translation>绘制更细的网格</translation>
    </message>
    <message>
        <source>Paint coarser mesh</source>
        <translation>绘制更粗的网格</translation>
    </message>
    <message>
        <source>Paint even mesh</source>
        <translation>绘制均匀的网格</translation>
    </message>
</context>
<context>
    <name>StiffnessFields</name>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
</context>
<context>
    <name>StrokeTool</name>
    <message>
        <source>To the right: larger; up: harder. Esc leaves it as it was</source>
        <translation>向右：变大；向上：变硬。按 Esc 保持原样</translation>
    </message>
    <message>
        <source>%1 px · %2 % hard</source>
        <translation>%1 px · 硬度 %2 %</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>&amp;Pin</source>
        <translation>图钉(&amp;P)</translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation>放置并拖动图钉</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>选择(&amp;L)</translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation>选择并拖动图钉，不放置新图钉</translation>
    </message>
    <message>
        <source>Grab by &amp;Lasso</source>
        <translation>套索抓取(&amp;L)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a drawn outline as one handle</source>
        <translation>将所画轮廓内的全部内容抓取为一个手柄</translation>
    </message>
    <message>
        <source>Grab by Bo&amp;x</source>
        <translation>矩形抓取(&amp;X)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a rectangle as one handle</source>
        <translation>将矩形内的全部内容抓取为一个手柄</translation>
    </message>
    <message>
        <source>Grab by &amp;Brush</source>
        <translation>画笔抓取(&amp;B)</translation>
    </message>
    <message>
        <source>Take hold of what is brushed over as one handle</source>
        <translation>将画笔刷过的部分抓取为一个手柄</translation>
    </message>
    <message>
        <source>Grab a B&amp;all</source>
        <translation>球体抓取(&amp;A)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a ball around a point on the surface</source>
        <translation>抓取以表面上一点为中心的球体内的全部内容</translation>
    </message>
    <message>
        <source>Grab a Bloc&amp;k</source>
        <translation>长方体抓取(&amp;K)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a block around a point on the surface</source>
        <translation>抓取以表面上一点为中心的长方体内的全部内容</translation>
    </message>
    <message>
        <source>Grab &amp;One Side</source>
        <translation>单侧抓取(&amp;O)</translation>
    </message>
    <message>
        <source>Take hold of all that lies beyond a plane through a point on the surface</source>
        <translation>抓取经过表面上一点的平面另一侧的全部内容</translation>
    </message>
    <message>
        <source>Outline by &amp;Lasso</source>
        <translation>套索轮廓(&amp;L)</translation>
    </message>
    <message>
        <source>Draw around what should bend, or should not</source>
        <translation>圈出要变形或不变形的部分</translation>
    </message>
    <message>
        <source>Outline by &amp;Polygon</source>
        <translation>多边形轮廓(&amp;P)</translation>
    </message>
    <message>
        <source>Set the corners of what should bend, or should not</source>
        <translation>逐点设定要变形或不变形部分的角点</translation>
    </message>
    <message>
        <source>Outline by &amp;Brush</source>
        <translation>画笔轮廓(&amp;B)</translation>
    </message>
    <message>
        <source>Brush over what should bend, or should not</source>
        <translation>用画笔刷过要变形或不变形的部分</translation>
    </message>
    <message>
        <source>Click a colour that should bend, or should not</source>
        <translation>单击要变形或不变形的颜色</translation>
    </message>
    <message>
        <source>Cut &amp;Apart</source>
        <translation>切开(&amp;A)</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape</source>
        <translation>画一条线，沿此线切开形状</translation>
    </message>
    <message>
        <source>&amp;Detail Brush</source>
        <translation>精细度画笔(&amp;D)</translation>
    </message>
    <message>
        <source>Brush where the mesh should be finer or coarser</source>
        <translation>用画笔刷过网格要更细或更粗的部分</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>绘制(&amp;P)</translation>
    </message>
    <message>
        <source>Paint what is kept, or how stiff it is</source>
        <translation>绘制保持内容或刚度</translation>
    </message>
    <message>
        <source>&amp;Comb</source>
        <translation>梳理(&amp;C)</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>梳理刚度的方向</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>渐变(&amp;G)</translation>
    </message>
    <message>
        <source>Drag to blend evenly from what is there to what is chosen</source>
        <translation>拖动：从原有内容均匀过渡到所选内容</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>填充(&amp;F)</translation>
    </message>
    <message>
        <source>Fill a connected area with what is chosen</source>
        <translation>用所选内容填充相连的全部</translation>
    </message>
    <message>
        <source>E&amp;yedropper</source>
        <translation>吸管(&amp;Y)</translation>
    </message>
    <message>
        <source>Pick up what is painted under the pointer</source>
        <translation>吸取指针处绘制的内容</translation>
    </message>
    <message>
        <source>Depth Brus&amp;h</source>
        <translation>深度画笔(&amp;H)</translation>
    </message>
    <message>
        <source>Brush over what lies in front where the shape covers itself</source>
        <translation>在形状自身重叠处，用画笔刷过位于前面的部分</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>测量(&amp;E)</translation>
    </message>
    <message>
        <source>Measure lengths and angles between points of the shape</source>
        <translation>测量形状上各点之间的长度和角度</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>橡皮擦(&amp;R)</translation>
    </message>
    <message>
        <source>Erase paint: what you brush over is like the rest again</source>
        <translation>去除绘制：刷过的部分恢复为与别处相同</translation>
    </message>
    <message>
        <source>&amp;Crop</source>
        <translation>裁剪(&amp;C)</translation>
    </message>
    <message>
        <source>Draw a rectangle around the part of the picture that exports keep</source>
        <translation>用矩形框住导出时要保留的图片部分</translation>
    </message>
    <message>
        <source>Pe&amp;n</source>
        <translation>钢笔(&amp;N)</translation>
    </message>
    <message>
        <source>Draw the path of a pin, point by point</source>
        <translation>逐点绘制图钉的路径</translation>
    </message>
    <message>
        <source>Pa&amp;n</source>
        <translation>平移(&amp;N)</translation>
    </message>
    <message>
        <source>Drag the view to another place; in every step, holding the space bar does so, too</source>
        <translation>将视图拖到别处；在每个步骤中空格键也可以</translation>
    </message>
    <message>
        <source>Magic &amp;Wand</source>
        <translation>魔棒(&amp;W)</translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>This picture is no SVG drawing: its pixels are what it has.</source>
        <translation>此图片不是 SVG 绘图：其像素是固定的。</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a picture, a mesh, a surface or a project</source>
        <translation>打开图片、网格、表面或项目</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>以其他名称保存项目</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>图片(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the bent picture at its full size</source>
        <translation>按原尺寸导出当前变形的图片</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Sequence…</source>
        <translation>序列(&amp;S)…</translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures or meshes</source>
        <translation>将运动导出为图片或网格序列</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation>导出每个像素的来源位置，供合成软件使用</translation>
    </message>
    <message>
        <source>&amp;Mesh…</source>
        <translation>网格(&amp;M)…</translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation>将变形后的网格导出为 OBJ、PLY、VTU…</translation>
    </message>
    <message>
        <source>&amp;View…</source>
        <translation>视图(&amp;V)…</translation>
    </message>
    <message>
        <source>Write the view as a picture, as large as you like</source>
        <translation>将视图导出为任意大小的图片</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation>关闭文件并返回起始页</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation>退出 Wend</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近打开的文件(&amp;R)</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>打开示例(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
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
        <translation>撤销上一步操作</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>重做已撤销的操作</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation>选择全部图钉(&amp;A)</translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation>选择全部图钉</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>取消选择(&amp;N)</translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation>不选择任何图钉</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>移除图钉(&amp;R)</translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation>移除所选图钉；已移动的部分保持不变</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Colour the shape by what changed</source>
        <translation>按变化程度为形状着色</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>&amp;Stiffness Marks</source>
        <translation>刚度标记(&amp;S)</translation>
    </message>
    <message>
        <source>Show where the shape is stiff, and along which direction</source>
        <translation>显示何处有刚度以及沿哪个方向</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation>只显示图片；按住 H 可暂时显示</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>变形前(&amp;B)</translation>
    </message>
    <message>
        <source>Show the shape as it was before it was bent; hold \ to do so for a moment</source>
        <translation>显示变形前的形状；按住 \ 可暂时显示</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>显示整张图片</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation>实际大小(&amp;A)</translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation>图片的一个像素对应屏幕的一个像素</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation>靠近查看</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>See more</source>
        <translation>查看更大范围</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>全屏(&amp;S)</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>使用整个屏幕</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
    <message>
        <source>Light or dark, like the desktop</source>
        <translation>明暗与桌面一致</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>浅底深字</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>深底浅字</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>循环(&amp;L)</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>播放到结尾后从头开始</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>跳到开头(&amp;S)</translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation>显示变形前的形状</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>跳到结尾(&amp;E)</translation>
    </message>
    <message>
        <source>Show the end of the motion</source>
        <translation>显示运动的结尾</translation>
    </message>
    <message>
        <source>Let the shape relax at the end, with the pins where they are</source>
        <translation>在运动结尾，图钉不动，让形状向原始形状松弛</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>How it works, page by page, with a search</source>
        <translation>逐页介绍用法，可搜索</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>按键与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>鼠标与按键的作用</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation>关于 Wend(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>版本与许可证</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>外观(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>运动(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>请先打开图片。</translation>
    </message>
    <message>
        <source>A solid has no pixels.</source>
        <translation>实体没有像素。</translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation>此项目没有图片。</translation>
    </message>
    <message>
        <source>A solid has no pixels: export the view.</source>
        <translation>实体没有像素：请导出视图。</translation>
    </message>
    <message>
        <source>For a picture, export the picture itself.</source>
        <translation>对于图片，请导出图片本身。</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>请先选择图钉。</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>还没有任何运动：请拖动图钉。</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>教程(&amp;T)</translation>
    </message>
    <message>
        <source>The first five minutes, on a sample, step by step</source>
        <translation>用示例一步一步带您度过最初五分钟</translation>
    </message>
    <message>
        <source>&amp;Velocity Arrows</source>
        <translation>速度箭头(&amp;V)</translation>
    </message>
    <message>
        <source>Show where the shape moves at this time</source>
        <translation>显示形状此刻向何处运动</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>&amp;Compare Energies</source>
        <translation>比较能量(&amp;C)</translation>
    </message>
    <message>
        <source>Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape</source>
        <translation>在旁边显示相同图钉下的另一种能量；也可将“保持”中的图块拖到形状上</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>录制(&amp;R)</translation>
    </message>
    <message>
        <source>Record every drag as it happens, in real time; Ctrl does so for one drag</source>
        <translation>每次拖动都按实际时间原样保留；按住 Ctrl 仅对一次拖动有效</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation>洋葱皮(&amp;O)</translation>
    </message>
    <message>
        <source>Show the shape as it was a little before and as it is a little after</source>
        <translation>显示稍前和稍后的形状</translation>
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
        <translation>播放的速度，也是录制所用的时钟</translation>
    </message>
    <message>
        <source>Speed: %1 %</source>
        <translation>速度：%1 %</translation>
    </message>
    <message>
        <source>Play or pause the motion; tapping the space bar does so, too</source>
        <translation>播放或暂停运动；轻按空格键也可</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>属性(&amp;P)</translation>
    </message>
    <message>
        <source>Show the properties on the right, or give their room to the shape</source>
        <translation>在右侧显示属性，或把空间留给形状</translation>
    </message>
    <message>
        <source>Size of M&amp;arks</source>
        <translation>标记大小(&amp;A)</translation>
    </message>
    <message>
        <source>How large pins, rings and curves are drawn, so that they are easy to see and to hit</source>
        <translation>形状上图钉、圆环和曲线的大小，便于看清和抓取</translation>
    </message>
    <message>
        <source>Rela&amp;x</source>
        <translation>松弛(&amp;X)</translation>
    </message>
    <message>
        <source>ST &amp;Map…</source>
        <translation>ST 贴图(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>历史记录(&amp;H)…</translation>
    </message>
    <message>
        <source>Show the undo history, and go back to any step</source>
        <translation>显示操作历史，并可返回任意一步</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>网格边(&amp;E)</translation>
    </message>
    <message>
        <source>Show the edges of the mesh</source>
        <translation>显示网格的边</translation>
    </message>
    <message>
        <source>&amp;Colour Overlay</source>
        <translation>颜色叠加(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Overlays</source>
        <translation>隐藏图钉和叠加层(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>影片(&amp;F)…</translation>
    </message>
    <message>
        <source>Write the motion as a film: MP4, WebM, QuickTime, GIF …</source>
        <translation>将运动写成影片：MP4、WebM、QuickTime、GIF 等</translation>
    </message>
    <message>
        <source>&amp;Pose at This Time</source>
        <translation>此刻的姿势(&amp;P)</translation>
    </message>
    <message>
        <source>In the step Animate, a drag sets where pins are at the time shown, and what they do before and after stays; off: it leads them on to the end of the film</source>
        <translation>在“动画”步骤中，拖动会设定固定点在所示时间的位置，前后的动作保持不变；关闭时则一直带到影片结尾</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>制作部件(&amp;P)</translation>
    </message>
    <message>
        <source>What is drawn as the outline becomes a part that bends by itself, or what you draw next; what is behind it is filled</source>
        <translation>已绘制的轮廓或接下来绘制的区域将成为独立弯曲的部件；其后方会被填充</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Keep the Pa&amp;th</source>
        <translation>保留路径(&amp;W)</translation>
    </message>
    <message>
        <source>Re&amp;place Picture…</source>
        <translation>替换图片(&amp;P)…</translation>
    </message>
    <message>
        <source>Bend another picture of the same proportions in the place of this one; pins and motions stay, and are scaled if it is larger or smaller</source>
        <translation>改为弯曲另一张比例相同的图片；图钉和动作保留，大小不同时会随之缩放</translation>
    </message>
    <message>
        <source>&amp;Apply Motion…</source>
        <translation>应用动作(&amp;A)…</translation>
    </message>
    <message>
        <source>Move this shape as another project moves its own: pins of the same name, with lengths in proportion to the sizes of both shapes</source>
        <translation>让此形状像另一项目那样运动：按同名图钉，长度按两个形状的大小成比例</translation>
    </message>
    <message>
        <source>A drag that follows another of the same pins at the end of the film leads them on by a second; off: it corrects that move, which becomes straight</source>
        <translation>在影片末尾再次拖动相同的图钉会让它们继续移动一秒；关闭时：修正上一次移动，使其变为直线</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>键盘快捷键(&amp;K)…</translation>
    </message>
    <message>
        <source>Give actions other keys</source>
        <translation>为操作指定其他按键</translation>
    </message>
    <message>
        <source>&amp;Drawing Size…</source>
        <translation>绘图大小(&amp;D)…</translation>
    </message>
    <message>
        <source>Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it</source>
        <translation>以更多或更少的像素绘制 SVG 绘图；图钉和动作随之缩放</translation>
    </message>
</context>
<context>
    <name>wend::BackdropChoice</name>
    <message>
        <source>Bac&amp;kdrop</source>
        <translation>背景(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>棋盘格(&amp;C)</translation>
    </message>
    <message>
        <source>Checks behind a picture, the workspace behind a solid</source>
        <translation>图片后为棋盘格，实体后为工作区</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>白色(&amp;W)</translation>
    </message>
    <message>
        <source>White behind the shape, to see dark edges</source>
        <translation>形状后为白色：可看出暗边</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>灰色(&amp;G)</translation>
    </message>
    <message>
        <source>Grey behind the shape</source>
        <translation>形状后为灰色</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>黑色(&amp;B)</translation>
    </message>
    <message>
        <source>Black behind the shape, to see light edges</source>
        <translation>形状后为黑色：可看出亮边</translation>
    </message>
</context>
<context>
    <name>wend::BalancePanel</name>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>此项目按论文的方式用 λ 平滑；程度由其文件给出。</translation>
    </message>
</context>
<context>
    <name>wend::BrushActions</name>
    <message>
        <source>&amp;Brush</source>
        <translation>画笔(&amp;B)</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>绘制 %1</translation>
    </message>
    <message>
        <source>Choose the step “Paint” first.</source>
        <translation>请先选择“绘制”步骤。</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>保持(&amp;K)</translation>
    </message>
    <message>
        <source>Paint what the shape keeps when it has to give way</source>
        <translation>绘制形状在变形时尽量保持的内容</translation>
    </message>
    <message>
        <source>&amp;Stiffness</source>
        <translation>刚度(&amp;S)</translation>
    </message>
    <message>
        <source>Paint how many times stiffer the shape is along a direction</source>
        <translation>绘制形状沿某一方向的刚度倍数</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>梳理刚度的方向</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ], or by dragging to the right with Alt and the right button.</source>
        <translation>画笔在屏幕上的直径；也可用 [ 和 ] 键，或用 Alt+右键向右拖动来更改。</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>硬度</translation>
    </message>
    <message>
        <source>How much of the brush paints fully; beyond that it fades out. Also by Shift with [ and ], or by dragging upwards with Alt and the right button.</source>
        <translation>画笔中完全绘制部分的比例；其外逐渐淡出。也可用 Shift 加 [ 或 ]，或用 Alt+右键向上拖动来更改。</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>How far a stroke goes from what is there to what is painted.</source>
        <translation>每一笔使原有内容向所绘内容靠近多少。</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>压感(&amp;P)</translation>
    </message>
    <message>
        <source>The harder a pen is pressed, the more of the amount is painted</source>
        <translation>笔压得越重，绘制的强度越大</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>What you brush over lies in front if this is greater than 0, behind if it is less</source>
        <translation>画笔刷过的部分，大于 0 时在前，小于 0 时在后</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>How long the mesh&apos;s edges are where you brush, compared with elsewhere</source>
        <translation>画笔刷过处的网格边长，相对于别处</translation>
    </message>
</context>
<context>
    <name>wend::CheatSheet</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>按键与鼠标</translation>
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
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>angle %1 · volume %2 · stretch %3</source>
        <translation>角度 %1 · 体积 %2 · 拉伸 %3</translation>
    </message>
    <message>
        <source>angle %1 · area %2 · stretch %3</source>
        <translation>角度 %1 · 面积 %2 · 拉伸 %3</translation>
    </message>
    <message>
        <source>The same with another energy</source>
        <translation>采用另一种能量的同一形状</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>结束比较</translation>
    </message>
    <message>
        <source>Shows one shape again.</source>
        <translation>恢复为只显示一个形状。</translation>
    </message>
    <message>
        <source>What this half keeps, or how it is without paint, with the same pins and motions.</source>
        <translation>这一半保持什么，或不涂绘时的样子；图钉与运动相同。</translation>
    </message>
    <message>
        <source>Nothing painted</source>
        <translation>无涂绘</translation>
    </message>
</context>
<context>
    <name>wend::CurveActions</name>
    <message>
        <source>&amp;Curve</source>
        <translation>曲线(&amp;C)</translation>
    </message>
    <message>
        <source>Edit &amp;Path</source>
        <translation>编辑路径(&amp;P)</translation>
    </message>
    <message>
        <source>Turn the last path of the selected pin into a Bézier curve</source>
        <translation>将所选图钉的最后一段路径变为贝塞尔曲线</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>&amp;Insert Point</source>
        <translation>插入点(&amp;I)</translation>
    </message>
    <message>
        <source>Split the curve at the pointer, or after the chosen point; its shape stays</source>
        <translation>在所指位置或所选点之后分割曲线；其形状不变</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>删除点(&amp;D)</translation>
    </message>
    <message>
        <source>Remove the chosen point from the curve</source>
        <translation>从曲线中删除所选的点</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>自由(&amp;F)</translation>
    </message>
    <message>
        <source>Let the two directions at the point be independent</source>
        <translation>点两侧的方向各自独立</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>&amp;Aligned</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>Keep both directions at the point on one line</source>
        <translation>点两侧的方向保持在一条直线上</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>自动(&amp;U)</translation>
    </message>
    <message>
        <source>Lead the curve smoothly through the point, guided by its neighbours</source>
        <translation>根据相邻点使曲线平滑地通过该点</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>Select one pin that was dragged along a path.</source>
        <translation>请选择一个沿路径拖动过的图钉。</translation>
    </message>
    <message>
        <source>Select one pin that follows a curve.</source>
        <translation>请选择一个沿曲线移动的图钉。</translation>
    </message>
    <message>
        <source>Click a point of the curve first; two must remain.</source>
        <translation>请先单击曲线上的点；至少须保留两个。</translation>
    </message>
    <message>
        <source>Click an inner point of a Bézier curve first.</source>
        <translation>请先单击贝塞尔曲线中间的点。</translation>
    </message>
</context>
<context>
    <name>wend::CurvePanel</name>
    <message>
        <source>Edit path</source>
        <translation>编辑路径</translation>
    </message>
    <message>
        <source>Turns the drawn path into a Bézier curve with points to drag.</source>
        <translation>将画出的路径变为可拖动各点的贝塞尔曲线。</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>as it bends (Frenet)</source>
        <translation>曲率 (Frenet)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Rotate with path</source>
        <translation>随路径旋转</translation>
    </message>
    <message>
        <source>Whether what is held turns along the curve, and how.</source>
        <translation>抓取的部分是否沿曲线旋转，以及如何旋转。</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>How far it turns around the curve&apos;s direction, over the whole curve.</source>
        <translation>在整条曲线上绕曲线方向转过的角度。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>How large it has become at the end of the curve.</source>
        <translation>到曲线终点时的大小。</translation>
    </message>
    <message>
        <source>Rot&amp;ate with path</source>
        <translation>随路径旋转(&amp;A)</translation>
    </message>
    <message>
        <source>T&amp;wist</source>
        <translation>扭转(&amp;W)</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>缩放(&amp;C)</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow: hold more vertices.</source>
        <translation>单个点无法旋转或放大：请抓取更多顶点。</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>更改曲线</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>缓动</translation>
    </message>
    <message>
        <source>How the motion at the shown time starts and ends.</source>
        <translation>所示时刻的运动如何开始和结束。</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>更改缓动</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow – drag its ring, or give it a radius.</source>
        <translation>点不能旋转或缩放——拖动其圆环，或为其设置半径。</translation>
    </message>
</context>
<context>
    <name>wend::CutOutPanel</name>
    <message>
        <source>Only a cut-out has this. An outline that you have drawn stays as you drew it.</source>
        <translation>只有抠图才有此设置。手绘的轮廓保持您所画的样子。</translation>
    </message>
</context>
<context>
    <name>wend::CutPanel</name>
    <message>
        <source>Not cut</source>
        <translation>不剖切</translation>
    </message>
    <message>
        <source>Whole cells</source>
        <translation>完整单元</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>精确</translation>
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
        <translation>翻转</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>垂直于 %1 剖切</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>另一侧</translation>
    </message>
    <message>
        <source>Turns the plane so that it is perpendicular to this axis.</source>
        <translation>使剖切面垂直于此轴。</translation>
    </message>
    <message>
        <source>Cuts away the other side of the plane.</source>
        <translation>去掉剖切面的另一侧。</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>剖切位置</translation>
    </message>
    <message>
        <source>Moves the plane through the solid.</source>
        <translation>在实体中移动剖切面。</translation>
    </message>
    <message>
        <source>Normal of the cut</source>
        <translation>剖切面法线</translation>
    </message>
    <message>
        <source>The direction that the plane faces, as x, y and z.</source>
        <translation>剖切面朝向的方向，以 x、y、z 表示。</translation>
    </message>
    <message>
        <source>Distance of the cut</source>
        <translation>剖切面距离</translation>
    </message>
    <message>
        <source>How far the plane is from the origin, along its normal.</source>
        <translation>剖切面沿法线到原点的距离。</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>&amp;Look inside</source>
        <translation>查看内部(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>距离(&amp;D)</translation>
    </message>
    <message>
        <source>There is no solid to cut yet.</source>
        <translation>还没有可剖切的实体。</translation>
    </message>
    <message>
        <source>Looks inside: by whole tetrahedra, or along the exact plane.</source>
        <translation>查看内部：按完整四面体，或沿精确平面。</translation>
    </message>
</context>
<context>
    <name>wend::DepthActions</name>
    <message>
        <source>Bring to &amp;Front</source>
        <translation>置于顶层(&amp;F)</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies in front of all else</source>
        <translation>在形状自身重叠处，所选图钉周围的部分位于其他一切之前</translation>
    </message>
    <message>
        <source>Ctrl+Shift+]</source>
        <translation>Ctrl+Shift+]</translation>
    </message>
    <message>
        <source>Send to &amp;Back</source>
        <translation>置于底层(&amp;B)</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies behind all else</source>
        <translation>在形状自身重叠处，所选图钉周围的部分位于其他一切之后</translation>
    </message>
    <message>
        <source>Ctrl+Shift+[</source>
        <translation>Ctrl+Shift+[</translation>
    </message>
    <message>
        <source>As &amp;Drawn</source>
        <translation>按原样(&amp;D)</translation>
    </message>
    <message>
        <source>What is around the selected pins has no order of its own</source>
        <translation>所选图钉周围的部分没有自己的顺序</translation>
    </message>
    <message>
        <source>&amp;Number…</source>
        <translation>数值(&amp;N)…</translation>
    </message>
    <message>
        <source>Give what is around the selected pins an order: the greater number lies in front</source>
        <translation>为所选图钉周围的部分指定顺序：数值越大越靠前</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>深度(&amp;D)</translation>
    </message>
    <message>
        <source>A solid has depth of its own.</source>
        <translation>实体本身就有深度。</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>请先选择图钉。</translation>
    </message>
    <message>
        <source>Bring to front</source>
        <translation>置于顶层</translation>
    </message>
    <message>
        <source>Send to back</source>
        <translation>置于底层</translation>
    </message>
    <message>
        <source>Depth as drawn</source>
        <translation>深度按原样</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Order (in front: greater than 0, behind: less):</source>
        <translation>顺序（大于 0 在前，小于 0 在后）：</translation>
    </message>
</context>
<context>
    <name>wend::DetailChooser</name>
    <message>
        <source>Choose Skin</source>
        <translation>选择蒙皮</translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>表面 (%1)</translation>
    </message>
    <message>
        <source>This surface cannot be embedded in the solid. %1</source>
        <translation>此表面无法随实体变形。%1</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>选择蒙皮</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>移除蒙皮</translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Go to the worst place</source>
        <translation>前往变形最大处</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Colour &amp;by</source>
        <translation>着色依据(&amp;B)</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>角度误差</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation>σ₁/σ₂ + σ₂/σ₁ − 2 在整个形状上的总和：所有角度都保持时为零。</translation>
    </message>
    <message>
        <source>Area error</source>
        <translation>面积误差</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>拉伸</translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation>长度与变形前相差多少：刚体运动时为零。</translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation>变形最大处</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>体积误差</translation>
    </message>
    <message>
        <source>Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.</source>
        <translation>det F + 1/det F − 2 在整个形状上的总和：所有体积都保持时为零。</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation>σ₁σ₂ + 1/(σ₁σ₂) − 2 在整个形状上的总和：所有面积都保持时为零。</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>着色依据</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>不透明度(&amp;P)</translation>
    </message>
    <message>
        <source>What is coloured over the solid: the error of lengths, volumes or angles, how far it is from where it was, the material, how fast it moves, or how fine its mesh is.</source>
        <translation>实体上以颜色表示的内容：长度、体积或角度的误差，与原位置的距离，材料，运动的快慢，或网格的精细程度。</translation>
    </message>
    <message>
        <source>What is coloured over the picture: the error of lengths, areas or angles, how far it is from where it was, the material, or how fast it moves.</source>
        <translation>图片上以颜色表示的内容：长度、面积或角度的误差，与原位置的距离，材料，或运动的快慢。</translation>
    </message>
    <message>
        <source>Smooth colo&amp;urs</source>
        <translation>平滑颜色(&amp;U)</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>极端变形</translation>
    </message>
    <message>
        <source>Passes through itself</source>
        <translation>自身穿透</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>自身交叉</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>无</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 处</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 个单元</translation>
    </message>
    <message numerus="yes">
        <source>%n cells</source>
        <translation>
            <numerusform>%n 个单元</numerusform>
        </translation>
    </message>
    <message>
        <source>This is checked once the pose is at rest.</source>
        <translation>姿态静止后才会查找。</translation>
    </message>
    <message>
        <source>There is no such place.</source>
        <translation>没有这样的位置。</translation>
    </message>
    <message>
        <source>No place is farther from rest than another.</source>
        <translation>没有哪处的变化比别处更大。</translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation>图钉误差</translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation>偏差最大的图钉距其应在位置多远</translation>
    </message>
    <message>
        <source>Computing time</source>
        <translation>计算时间</translation>
    </message>
    <message>
        <source>How long the shown shape took to compute</source>
        <translation>计算所示形状所用的时间</translation>
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
        <translation>锁定色标</translation>
    </message>
    <message>
        <source>How much the overlay covers the picture, or the colours of the solid, below it.</source>
        <translation>叠加层对下方图片或实体颜色的遮盖程度。</translation>
    </message>
    <message>
        <source>Blends the colours of the overlay from cell to cell. If off, each cell has the one colour of its value.</source>
        <translation>使叠加层的颜色在单元之间均匀过渡。关闭时，每个单元只有其值的一种颜色。</translation>
    </message>
    <message>
        <source>Keeps the range of the colours, to compare different shapes and energies.</source>
        <translation>保持颜色范围不变，以便比较不同的形状和能量。</translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the overlay.</source>
        <translation>将畸变最大的三角形移入视图；叠加层中以圆圈标出。</translation>
    </message>
    <message>
        <source>The tetrahedron that is farthest from rest in what the overlay shows.</source>
        <translation>按叠加层所示的量，与变形前相差最大的四面体。</translation>
    </message>
    <message>
        <source>The triangle that is farthest from rest in what the overlay shows.</source>
        <translation>按叠加层所示的量，与变形前相差最大的三角形。</translation>
    </message>
    <message>
        <source>In how many places the surface passes through itself once the pose is at rest, each with its pairs of triangles. A click goes to the next one; the overlay marks them in red.</source>
        <translation>姿态静止后表面自身穿透的处数，每处由若干对三角形组成。单击查看下一处；叠加层中以红色标出。</translation>
    </message>
    <message>
        <source>Where the outline crosses itself once the pose is at rest: one part lies over another. A click goes to the next one; the overlay marks them in red.</source>
        <translation>姿态静止后轮廓与自身相交之处：一部分盖在另一部分上。单击查看下一处；叠加层中以红色标出。</translation>
    </message>
    <message>
        <source>Tetrahedra with more than ten times their volume, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>体积超过原来十倍或不足十分之一的四面体。单击查看下一处；叠加层中以红色标出。</translation>
    </message>
    <message>
        <source>Triangles with more than ten times their area, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>面积超过原来十倍或不足十分之一的三角形。单击查看下一处；叠加层中以红色标出。</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>颜色下限</translation>
    </message>
    <message>
        <source>The value of the first colour. A typed value locks the scale; “≤” in the legend says that some places have less.</source>
        <translation>第一种颜色的值。输入的值会锁定标尺；图例中的“≤”表示有些位置的值更小。</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>颜色上限</translation>
    </message>
    <message>
        <source>The value of the last colour. A typed value locks the scale; “≥” in the legend says that some places have more.</source>
        <translation>最后一种颜色的值。输入的值会锁定标尺；图例中的“≥”表示有些位置的值更大。</translation>
    </message>
    <message>
        <source>Spreads the colours evenly over the orders of magnitude of the values.</source>
        <translation>将颜色均匀分布在数值的各个数量级上。</translation>
    </message>
    <message>
        <source>Colours from, to</source>
        <translation>颜色范围</translation>
    </message>
    <message>
        <source>These colours are those of the four energies.</source>
        <translation>这些颜色是四种能量的颜色。</translation>
    </message>
    <message>
        <source>The scale of this measure is fixed.</source>
        <translation>此度量的标尺是固定的。</translation>
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
        <translation>绘图大小</translation>
    </message>
    <message>
        <source>The drawing becomes a picture of this size. Pins, paths and regions are scaled with it; exported SVG files keep the drawing&apos;s own units.</source>
        <translation>绘图成为此大小的图片。图钉、路径和区域随之缩放；导出的 SVG 文件保留绘图自身的单位。</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>比例(&amp;S)</translation>
    </message>
    <message>
        <source>Of the size at which the drawing is opened</source>
        <translation>相对于打开绘图时的大小</translation>
    </message>
</context>
<context>
    <name>wend::EaseEditor</name>
    <message>
        <source>Easing Curve</source>
        <translation>缓动曲线</translation>
    </message>
    <message>
        <source>Speed at the &amp;start</source>
        <translation>开始时的速度(&amp;S)</translation>
    </message>
    <message>
        <source>Speed at the &amp;end</source>
        <translation>结束时的速度(&amp;E)</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>In percent of the speed of an even move: at 0 % the pin stops there.</source>
        <translation>占匀速移动速度的百分比：为 0 % 时图钉在该处停住。</translation>
    </message>
    <message>
        <source>Speed at the start</source>
        <translation>开始时的速度</translation>
    </message>
    <message>
        <source>Speed at the end</source>
        <translation>结束时的速度</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>The pin stays where it was, and goes on from there afterwards.</source>
        <translation>图钉停在原处，之后从那里继续。</translation>
    </message>
    <message>
        <source>Choose a bar or a key in the tracks.</source>
        <translation>请在轨道中选择一个条或关键姿势。</translation>
    </message>
    <message>
        <source>Rotations and scalings have one of the four easings.</source>
        <translation>旋转和缩放只有四种缓动之一。</translation>
    </message>
    <message>
        <source>1 motion</source>
        <translation>1 个动作</translation>
    </message>
    <message numerus="yes">
        <source>%n motions</source>
        <translation>
            <numerusform>%n 个动作</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::EasePlot</name>
    <message>
        <source>Easing curve</source>
        <translation>缓动曲线</translation>
    </message>
    <message>
        <source>How far the pin has come over time. Drag the two handles up or down; Left and Right choose one, Up and Down move it.</source>
        <translation>图钉随时间走过的路程。上下拖动两个手柄；左右键选择手柄，上下键移动它。</translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>What the shape keeps where it has to give way: from its volume, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>形状在变形时尽量保持的内容：从体积，经长度和刚性部分，到细节的外观。位于两个名称之间时兼具两者。</translation>
    </message>
    <message>
        <source>What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>形状在变形时尽量保持的内容：从面积，经长度和刚性部分，到细节的外观。位于两个名称之间时兼具两者。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
</context>
<context>
    <name>wend::ExportDialog</name>
    <message>
        <source>Export Picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>Export Sequence</source>
        <translation>导出序列</translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation>导出 ST 贴图</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>导出网格</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>导出影片</translation>
    </message>
</context>
<context>
    <name>wend::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>要导出的文件类型。</translation>
    </message>
    <message>
        <source>Fit the Can&amp;vas</source>
        <translation>调整画布(&amp;V)</translation>
    </message>
    <message>
        <source>Fit the canvas</source>
        <translation>调整画布</translation>
    </message>
    <message>
        <source>Make the canvas as large as the shape needs, so that nothing is cut off.</source>
        <translation>使画布达到形状所需的大小，不裁掉任何内容。</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>格式(&amp;O)</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>与图片相同</translation>
    </message>
    <message>
        <source>As it suits the format best</source>
        <translation>按格式取最佳</translation>
    </message>
    <message>
        <source>%1 px on the left</source>
        <translation>左侧 %1 px</translation>
    </message>
    <message>
        <source>%1 px at the top</source>
        <translation>顶部 %1 px</translation>
    </message>
    <message>
        <source>%1 px on the right</source>
        <translation>右侧 %1 px</translation>
    </message>
    <message>
        <source>%1 px at the bottom</source>
        <translation>底部 %1 px</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>As it moves, the shape leaves the picture and is cut off there: %1.</source>
        <translation>形状在运动途中超出图片，会被裁掉：%1。</translation>
    </message>
    <message>
        <source>The shape reaches beyond the picture and is cut off there: %1.</source>
        <translation>形状超出图片，会被裁掉：%1。</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 个顶点</translation>
    </message>
    <message numerus="yes">
        <source>%n shapes of %1</source>
        <translation>
            <numerusform>%n 个形状，每个 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures of %1</source>
        <translation>
            <numerusform>%n 张图片，每张 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>已裁剪</translation>
    </message>
    <message>
        <source>%1 has no transparency: pictures are placed on white.</source>
        <translation>%1 不支持透明：图片放在白色上。</translation>
    </message>
</context>
<context>
    <name>wend::ExportPanel</name>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>ST Map</source>
        <translation>ST 贴图</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Choose a name and write what the preview shows.</source>
        <translation>选择名称并写出预览所示的内容。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>影片</translation>
    </message>
</context>
<context>
    <name>wend::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>What will be written, smaller</source>
        <translation>将要导出的内容（缩小显示）</translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>Writing the picture …</source>
        <translation>正在导出图片…</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n frames …</source>
        <translation>
            <numerusform>正在导出 %n 帧…</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation>正在导出网格…</translation>
    </message>
    <message>
        <source>“%1” is this project itself. Replace it?</source>
        <translation>“%1”就是此项目本身。要替换吗？</translation>
    </message>
    <message>
        <source>“%1” is the picture that this project bends. Replace it?</source>
        <translation>“%1”是此项目正在变形的图片。要替换吗？</translation>
    </message>
    <message>
        <source>“%1” is the mesh that this project bends. Replace it?</source>
        <translation>“%1”是此项目正在变形的网格。要替换吗？</translation>
    </message>
    <message>
        <source>“%1” belongs to this project. Replace it?</source>
        <translation>“%1”属于此项目。要替换吗？</translation>
    </message>
    <message>
        <source>Another export is still being written. Try again in a moment.</source>
        <translation>另一个导出仍在写入。请稍后再试。</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>形状仍在计算中。请稍后再试。</translation>
    </message>
    <message>
        <source>There is no shape to export: it could not be computed.</source>
        <translation>没有可导出的形状：未能计算出来。</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message numerus="yes">
        <source>Replace the frames that already exist (%n)?</source>
        <translation>
            <numerusform>其中 %n 帧已存在。要替换吗？</numerusform>
        </translation>
    </message>
    <message>
        <source>What it holds now will be lost, and the project will no longer open as it is.</source>
        <translation>其当前内容将丢失，项目将无法再按原样打开。</translation>
    </message>
    <message>
        <source>What they hold now will be lost.</source>
        <translation>它们当前的内容将丢失。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>未导出任何内容。%1</translation>
    </message>
    <message>
        <source>Written without velocities: %1 (%2)</source>
        <translation>已导出，不含速度：%1（%2）</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已导出：%1</translation>
    </message>
    <message>
        <source>Export Material</source>
        <translation>导出材料</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>图片 (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Writing the ST map …</source>
        <translation>正在导出 ST 贴图…</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>正在写入影片…</translation>
    </message>
</context>
<context>
    <name>wend::FactsPanel</name>
    <message>
        <source>size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>边</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>mean edge</source>
        <translation>平均边长</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>boundary loops</source>
        <translation>边界环</translation>
    </message>
    <message>
        <source>genus</source>
        <translation>亏格</translation>
    </message>
    <message>
        <source>crossing pairs</source>
        <translation>相交对</translation>
    </message>
    <message>
        <source>Worst cell</source>
        <translation>最差单元</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>下一个缝隙</translation>
    </message>
    <message>
        <source>Open the widest</source>
        <translation>打开最宽的缝隙</translation>
    </message>
    <message>
        <source>Facts of the file</source>
        <translation>文件数据</translation>
    </message>
    <message>
        <source>The surface as it is in its file. Lengths are in the file&apos;s units, which few files name.</source>
        <translation>文件中原样的表面。长度采用文件的单位，但很少有文件注明。</translation>
    </message>
    <message>
        <source>Quality of the cells</source>
        <translation>单元质量</translation>
    </message>
    <message>
        <source>Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are above that, and how many triangles of the surface force them.</source>
        <translation>最差四面体的外接半径与最短边之比、要求值、超出的数量，以及迫使其如此的表面三角形数量。</translation>
    </message>
    <message>
        <source>Closed gaps</source>
        <translation>被封闭的缝隙</translation>
    </message>
    <message>
        <source>Gaps within one part that the cage closes: what lies on both sides moves together.</source>
        <translation>笼子封闭的同一部件内的缝隙：两侧会一起移动。</translation>
    </message>
    <message>
        <source>Goes to the tetrahedron with the largest ratio.</source>
        <translation>查看比值最大的四面体。</translation>
    </message>
    <message>
        <source>Goes through the gaps that the cage closes, one after another.</source>
        <translation>依次查看笼子封闭的缝隙。</translation>
    </message>
    <message>
        <source>Makes the cage so fine that the widest of these gaps stays open.</source>
        <translation>将笼子细化到使其中最宽的缝隙保持打开。</translation>
    </message>
    <message>
        <source>Looking at the file …</source>
        <translation>正在检查文件…</translation>
    </message>
    <message>
        <source>Surface of the file</source>
        <translation>文件的表面</translation>
    </message>
    <message>
        <source>worst ratio</source>
        <translation>最差比值</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>要求值</translation>
    </message>
    <message>
        <source>cells above</source>
        <translation>超出的单元</translation>
    </message>
    <message>
        <source>forced by triangles</source>
        <translation>迫使的三角形</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>四面体</translation>
    </message>
    <message>
        <source>That would take more than a million vertices.</source>
        <translation>那需要超过一百万个顶点。</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>笼子</translation>
    </message>
    <message>
        <source>closed gaps</source>
        <translation>封闭的缝隙</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>最窄</translation>
    </message>
    <message>
        <source>Open a gap</source>
        <translation>打开缝隙</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>侧面</translation>
    </message>
</context>
<context>
    <name>wend::FileCard</name>
    <message>
        <source>Sample: %1</source>
        <translation>示例：%1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation>打开示例“%1”</translation>
    </message>
    <message>
        <source>%1, solid</source>
        <translation>%1（实体）</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>Open the unsaved changes to “%1”</source>
        <translation>打开“%1”的未保存更改</translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation>Wend 可打开的所有文件 (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>项目 (*.wend)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>网格 (%1)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>%1 has moved.</source>
        <translation>%1 已不在原处。</translation>
    </message>
    <message>
        <source>Find It…</source>
        <translation>查找…</translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation>无法打开此文件。%1</translation>
    </message>
    <message>
        <source>Nothing to see in this picture.</source>
        <translation>此图片中没有可见内容。</translation>
    </message>
    <message>
        <source>Use Whole Frame</source>
        <translation>使用整张图片</translation>
    </message>
    <message>
        <source>Open Another…</source>
        <translation>打开其他文件…</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>所有文件</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>查找 %1</translation>
    </message>
    <message>
        <source>Your changes cannot be recovered if the program crashes: please save. %1</source>
        <translation>如果程序崩溃，您的更改没有副本：请保存。%1</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>“%1” was changed by another program or window.</source>
        <translation>“%1”已被其他程序或窗口更改。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新载入</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>保留我的更改</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>要重新载入“%1”吗？</translation>
    </message>
    <message>
        <source>Your changes since it was saved will be lost.</source>
        <translation>您自上次保存以来的更改将丢失。</translation>
    </message>
    <message>
        <source>Saving replaces those changes; reloading discards yours.</source>
        <translation>保存会替换那些更改；重新载入会丢弃您的更改。</translation>
    </message>
    <message>
        <source>The project was not saved: it needs the file “%1” itself. Choose another name.</source>
        <translation>项目未保存：它需要文件“%1”本身。请选择其他名称。</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation>项目未保存。%1</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>If you do not save, they will be lost.</source>
        <translation>如果不保存，更改将丢失。</translation>
    </message>
    <message>
        <source>Wend was not closed properly: there are unsaved changes to “%1”.</source>
        <translation>Wend 未正常关闭：“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Discard the unsaved changes to “%1”? They cannot be brought back.</source>
        <translation>放弃“%1”的未保存更改？将无法恢复。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save what you made of “%1”?</source>
        <translation>要保存您用“%1”做的内容吗？</translation>
    </message>
    <message>
        <source>It becomes a project of its own; the file stays as it is. If you do not save, what you made will be lost.</source>
        <translation>它会成为单独的项目，原文件保持不变。如果不保存，所做的内容将丢失。</translation>
    </message>
    <message>
        <source>“%1” %2.</source>
        <comment>a file, and what is wrong with it</comment>
        <translation>“%1”%2。</translation>
    </message>
    <message>
        <source>Pictures with layers (%1)</source>
        <translation>带图层的图片 (%1)</translation>
    </message>
</context>
<context>
    <name>wend::FilmPanel</name>
    <message>
        <source>Cycle</source>
        <translation>循环段</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Choose sound</source>
        <translation>选择声音</translation>
    </message>
    <message>
        <source>A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films.</source>
        <translation>其声音随运动开始的文件，会进入 MP4、WebM 和 QuickTime 影片。</translation>
    </message>
    <message>
        <source>Remove sound</source>
        <translation>移除声音</translation>
    </message>
    <message>
        <source>The film has no sound then.</source>
        <translation>影片将没有声音。</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>The part of the film that repeats, in seconds. A film that is exported as a loop shows it, and no picture twice.</source>
        <translation>影片中重复的部分，以秒为单位。作为循环导出的影片只显示这一段，且没有重复的画面。</translation>
    </message>
    <message>
        <source>from</source>
        <translation>从</translation>
    </message>
    <message>
        <source>to</source>
        <translation>到</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>更改循环段</translation>
    </message>
    <message>
        <source>Choose Sound</source>
        <translation>选择声音</translation>
    </message>
    <message>
        <source>Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</source>
        <translation>声音和影片 (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</translation>
    </message>
</context>
<context>
    <name>wend::FlowPanel</name>
    <message>
        <source>Relax</source>
        <translation>松弛</translation>
    </message>
    <message>
        <source>The pins stay where they are, and what lies between them releases its tension. This takes one second at the end of the film.</source>
        <translation>图钉不动，图钉之间的部分释放张力。这会占用影片末尾的一秒。</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>回弹</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>还没有任何运动。</translation>
    </message>
    <message>
        <source>A shape that springs back fully is always relaxed.</source>
        <translation>完全回弹的形状始终是松弛的。</translation>
    </message>
</context>
<context>
    <name>wend::GroupList</name>
    <message>
        <source>Hold It</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Groups of the file</source>
        <translation>文件中的组</translation>
    </message>
    <message>
        <source>What the mesh&apos;s file calls by a name or number. A click marks a group on the shape; a double click, or Enter, pins it.</source>
        <translation>网格文件用名称或编号称呼的部分。单击在形状上标出一组；双击或按 Enter 将其钉住。</translation>
    </message>
    <message>
        <source>Hold the group</source>
        <translation>固定该组</translation>
    </message>
    <message>
        <source>Makes a pin of the chosen group, which the project names, so that it fits other meshes, too.</source>
        <translation>将所选的组做成图钉。项目记录其名称，因此也适用于其他网格。</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>线</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>体</translation>
    </message>
    <message>
        <source>%1 (%2 %3)</source>
        <comment>name, number and kind of cells</comment>
        <translation>%1（%2 %3）</translation>
    </message>
</context>
<context>
    <name>wend::HandlePanel</name>
    <message>
        <source>Select a pin to see its numbers.</source>
        <translation>选择图钉以查看其数值。</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Exact step</source>
        <translation>精确变换</translation>
    </message>
    <message>
        <source>Moves, rotates or scales what is selected by exact numbers.</source>
        <translation>按精确数值移动、旋转或缩放所选内容。</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>How far along x, y and z; an angle; or a factor.</source>
        <translation>沿 x、y、z 的距离；角度；或倍数。</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>绕 X</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>绕 Y</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>绕 Z</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>The axis of the rotation, through the middle of what is selected.</source>
        <translation>经过所选内容中心的旋转轴。</translation>
    </message>
    <message>
        <source>Applies this step; it becomes part of the motion.</source>
        <translation>执行此变换，并计入运动。</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>图钉</translation>
    </message>
    <message>
        <source>at %1, %2, %3</source>
        <translation>位于 %1, %2, %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>位于 %1，%2</translation>
    </message>
    <message>
        <source>does not hold now</source>
        <translation>现在不固定</translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>wend::KeyPoseStrip</name>
    <message>
        <source>Key poses</source>
        <translation>关键姿势</translation>
    </message>
    <message>
        <source>The shape at the key poses of all pins: a click goes there</source>
        <translation>所有图钉关键姿势处的形状：单击即可转到该处</translation>
    </message>
    <message>
        <source>Key pose at %1</source>
        <translation>关键姿势：%1</translation>
    </message>
</context>
<context>
    <name>wend::LanguageChoice</name>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
    <message>
        <source>Speak the desktop&apos;s language, if Wend knows it</source>
        <translation>如果 Wend 支持，就使用桌面的语言</translation>
    </message>
    <message>
        <source>Speak %1</source>
        <translation>使用%1</translation>
    </message>
    <message>
        <source>The language of the window, from the next start of Wend</source>
        <translation>窗口的语言，下次启动 Wend 时生效</translation>
    </message>
    <message>
        <source>The language changes when Wend starts the next time.</source>
        <translation>下次启动 Wend 时语言将会改变。</translation>
    </message>
</context>
<context>
    <name>wend::LayerPanel</name>
    <message>
        <source>The material is the same everywhere: brush over the shape to change a part.</source>
        <translation>各处相同：用画笔刷过形状可更改局部。</translation>
    </message>
    <message>
        <source>Each along a direction of its own.</source>
        <translation>各有自己的方向。</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Lets the chosen layer win over the one above it.</source>
        <translation>使所选图层优先于其上方的图层。</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Lets the layer below win over the chosen one.</source>
        <translation>使下方的图层优先于所选图层。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes the chosen layer.</source>
        <translation>移除所选图层。</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>How many times stiffer the layer is along its direction; ×1 is the same as everywhere.</source>
        <translation>图层沿其方向的刚度是几倍；×1 与别处相同。</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>刚度方向</translation>
    </message>
    <message>
        <source>At rest; it turns with the shape. A change is for all regions of the layer.</source>
        <translation>变形前的方向；随形状转动。更改后适用于图层的所有区域。</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>羽化</translation>
    </message>
    <message>
        <source>How wide the edge fades, in the shape&apos;s own units.</source>
        <translation>边缘淡出的宽度，以形状自身的单位计。</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>羽化(&amp;G)</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>重命名图层</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>移动图层</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>移除图层</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>更改羽化</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>更改图层</translation>
    </message>
    <message>
        <source>Unnamed</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>Where the material differs. The topmost layer wins; drag a layer to move it. A click shows its values, a double-click changes its name, its eye or the space bar switches it off.</source>
        <translation>材料与别处不同之处。最上面的图层优先：可将图层拖到所需位置。单击显示其数值，双击更改名称，单击眼睛图标或按空格键将其关闭。</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Imports the material from pictures made in a paint program, and exports it as such.</source>
        <translation>从绘画软件的图片导入材料，也可导出为图片。</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Takes the pictures as they are now, after they have been saved in a paint program.</source>
        <translation>读取图片的当前内容：在绘画软件中保存之后使用。</translation>
    </message>
    <message>
        <source>Read pictures again</source>
        <translation>重新读取图片</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>隐藏图层</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>显示图层</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>保持：%1</translation>
    </message>
    <message>
        <source>Stiffness: %1</source>
        <translation>刚度：%1</translation>
    </message>
    <message>
        <source>Direction: %1</source>
        <translation>方向：%1</translation>
    </message>
    <message>
        <source>As the project&apos;s file says, cell by cell.</source>
        <translation>按项目文件所载，逐个单元。</translation>
    </message>
    <message>
        <source>Cell by cell: %1</source>
        <translation>逐个单元：%1</translation>
    </message>
    <message>
        <source>Values of cells</source>
        <translation>单元数值</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>向下合并(&amp;M)</translation>
    </message>
    <message>
        <source>Makes one layer of the chosen one and the one below it</source>
        <translation>将所选图层与其下方的图层合为一个</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>合并图层</translation>
    </message>
    <message>
        <source>Stiffness ×1 has no direction: first choose how many times stiffer it is.</source>
        <translation>刚度 ×1 没有方向：请先选择刚度的倍数。</translation>
    </message>
    <message>
        <source>What a file gives cell by cell stays lowest.</source>
        <translation>文件给出的逐单元数值始终在最底层。</translation>
    </message>
    <message>
        <source>This is already the lowest layer.</source>
        <translation>已经是最底层。</translation>
    </message>
    <message>
        <source>This is already the topmost layer.</source>
        <translation>已经是最顶层。</translation>
    </message>
    <message>
        <source>One of the two is switched off, is a picture, or erases.</source>
        <translation>两者之一已关闭、是图片，或用于擦除。</translation>
    </message>
    <message>
        <source>There is no layer below it.</source>
        <translation>下面没有图层。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>What a file says of each cell has no name.</source>
        <translation>文件对每个单元的设定没有名称。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Whether the layer changes Keep, and to what.</source>
        <translation>图层是否更改“保持”，以及更改为什么。</translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1：从 %2 到 %3</translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>主工具栏</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation>%1[*] – Wend</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Let go to open “%1”</source>
        <translation>松开以打开“%1”</translation>
    </message>
    <message numerus="yes">
        <source>Let go to open %n pictures as parts</source>
        <translation>
            <numerusform>松开以将 %n 张图片作为部件打开</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>The first page</source>
        <translation>第一页</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>The previous page</source>
        <translation>上一个页面</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>没有页面包含此内容。</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>Enter goes to the next place with these words, on this page or another.</source>
        <translation>按 Enter 转到下一处含这些词的位置，在本页或其他页。</translation>
    </message>
</context>
<context>
    <name>wend::MaterialActions</name>
    <message>
        <source>A grey picture over the whole, as a layer: black keeps area, white keeps angles</source>
        <translation>覆盖整体的灰度图片，作为图层：黑色保持面积，白色保持角度</translation>
    </message>
    <message>
        <source>Import &amp;Stiffness…</source>
        <translation>导入刚度(&amp;S)…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer: black is the same as everywhere, white is 1000 times stiffer</source>
        <translation>覆盖整体的灰度图片，作为图层：黑色与别处相同，白色的刚度为 1000 倍</translation>
    </message>
    <message>
        <source>Import &amp;Directions…</source>
        <translation>导入方向(&amp;D)…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer, of the direction of stiffness: black is level, middle grey upright</source>
        <translation>覆盖整体的灰度图片，作为图层：黑色为水平，中灰为竖直，刚度沿该方向起作用</translation>
    </message>
    <message>
        <source>Import Values of &amp;Cells…</source>
        <translation>导入单元数值(&amp;C)…</translation>
    </message>
    <message>
        <source>φ and B of every cell from a mesh file that contains them, such as an exported one</source>
        <translation>从含有 φ 和 B 的网格文件（例如导出的文件）读取每个单元的 φ 和 B</translation>
    </message>
    <message>
        <source>As a grey picture, to be edited in a paint program</source>
        <translation>导出为灰度图片，以便在绘画软件中继续绘制</translation>
    </message>
    <message>
        <source>Export S&amp;tiffness…</source>
        <translation>导出刚度(&amp;T)…</translation>
    </message>
    <message>
        <source>Export Di&amp;rections…</source>
        <translation>导出方向(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>材料(&amp;M)</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>请先打开图片。</translation>
    </message>
    <message>
        <source>For a solid, these are values of cells; they are exported with its mesh.</source>
        <translation>对于实体，这些是单元数值，随其网格一起导出。</translation>
    </message>
    <message>
        <source>Only the cells of a mesh file stay the same.</source>
        <translation>只有网格文件的单元保持不变。</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Values of cells (*.vtu *.vtk *.json)</source>
        <translation>单元数值 (*.vtu *.vtk *.json)</translation>
    </message>
    <message>
        <source>The layers were switched off: what was imported lies below them.</source>
        <translation>图层已关闭：导入的内容位于图层之下。</translation>
    </message>
    <message>
        <source>Import &amp;Keep…</source>
        <translation>导入“保持”(&amp;K)…</translation>
    </message>
    <message>
        <source>Export K&amp;eep…</source>
        <translation>导出“保持”(&amp;E)…</translation>
    </message>
</context>
<context>
    <name>wend::MaterialPanel</name>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Between %1 and %2.</source>
        <translation>介于%1与%2之间。</translation>
    </message>
    <message>
        <source>Grown ×%1 – try %2</source>
        <translation>已放大 ×%1 – 试试%2</translation>
    </message>
    <message>
        <source>The shape has become much larger than at rest. A click keeps more of its size.</source>
        <translation>形状比变形前大了许多。单击可更多地保持其大小。</translation>
    </message>
    <message>
        <source>Whole shape</source>
        <translation>整个形状</translation>
    </message>
    <message>
        <source>Keep: whole shape</source>
        <translation>保持：整个形状</translation>
    </message>
</context>
<context>
    <name>wend::MeasurePanel</name>
    <message>
        <source>Measures</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Size of the solid</source>
        <translation>实体尺寸</translation>
    </message>
    <message>
        <source>Volume and area of the surface, now and at rest.</source>
        <translation>体积和表面积，当前与变形前。</translation>
    </message>
    <message>
        <source>Size of what is selected</source>
        <translation>所选内容的尺寸</translation>
    </message>
    <message>
        <source>Volume of the tetrahedra and area of the outer triangles that the selected handles hold.</source>
        <translation>所选手柄抓取的四面体体积和外侧三角形面积。</translation>
    </message>
    <message>
        <source>Vertex under the pointer</source>
        <translation>指针处的顶点</translation>
    </message>
    <message>
        <source>The nearest vertex and where it is.</source>
        <translation>最近的顶点及其位置。</translation>
    </message>
    <message>
        <source>Tetrahedron under the pointer</source>
        <translation>指针处的四面体</translation>
    </message>
    <message>
        <source>All values of the tetrahedron.</source>
        <translation>该四面体的所有数值。</translation>
    </message>
    <message>
        <source>%1, at rest %2</source>
        <translation>%1（变形前 %2）</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>The whole</source>
        <translation>整体</translation>
    </message>
    <message numerus="yes">
        <source>Selected vertices: %n</source>
        <translation>
            <numerusform>已选择：%n 个顶点</numerusform>
        </translation>
    </message>
    <message>
        <source>Point at the solid to see the values there.</source>
        <translation>将指针移到实体上以查看该处的数值。</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>变形前</translation>
    </message>
    <message>
        <source>pointed at</source>
        <translation>指针位置</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>dihedral angles</source>
        <translation>二面角</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>circumradius to shortest edge</source>
        <translation>外接球半径与最短边之比</translation>
    </message>
    <message>
        <source>Tetrahedron %1</source>
        <translation>四面体 %1</translation>
    </message>
</context>
<context>
    <name>wend::MemorySlider</name>
    <message>
        <source>not at all</source>
        <translation>无</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>完全</translation>
    </message>
</context>
<context>
    <name>wend::MeshPanel</name>
    <message>
        <source>Vertices</source>
        <translation>顶点数</translation>
    </message>
    <message>
        <source>Maximum volume</source>
        <translation>最大体积</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>What sets how fine the mesh is: how many vertices it has in total, or how large a tetrahedron may be.</source>
        <translation>网格的精细度由什么决定：顶点总数，或允许的最大四面体。</translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>绘制…</translation>
    </message>
    <message>
        <source>Cell sizes</source>
        <translation>单元尺寸</translation>
    </message>
    <message>
        <source>Paints where the mesh should be finer or coarser, or sets it by regions in numbers.</source>
        <translation>绘制网格要更细或更粗之处，或用区域以数值指定。</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>A&amp;im at</source>
        <translation>目标(&amp;I)</translation>
    </message>
    <message>
        <source>Detail: coarse – fine</source>
        <translation>精细度：粗 – 细</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>更细与更粗</translation>
    </message>
    <message>
        <source>Aim at a volume</source>
        <translation>以体积为目标</translation>
    </message>
    <message>
        <source>Aim at vertices</source>
        <translation>以顶点数为目标</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>网格来自文件，按原样使用。</translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation>此图片没有透明部分。</translation>
    </message>
    <message>
        <source>No outline has been drawn.</source>
        <translation>尚未绘制轮廓。</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 个顶点，%2 个四面体</translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation>%1 个顶点，%2 个三角形</translation>
    </message>
    <message>
        <source>Outline and detail of</source>
        <translation>轮廓和细节所属</translation>
    </message>
    <message>
        <source>Which part of the picture has the outline and detail below; all have the same unless one has its own. Choosing a part in the list of parts chooses it here.</source>
        <translation>下面的轮廓和细节属于图片的哪个部件；除非部件有自己的设置，否则全部相同。在部件列表中选择部件时这里也会选中。</translation>
    </message>
    <message>
        <source>As All Parts</source>
        <translation>与所有部件相同</translation>
    </message>
    <message>
        <source>Gives this part the outline and detail of all parts again.</source>
        <translation>使此部件的轮廓和细节恢复为与所有部件相同。</translation>
    </message>
    <message>
        <source>&amp;Of</source>
        <translation>所属(&amp;F)</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>所有部件</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>选择蒙皮</translation>
    </message>
    <message>
        <source>Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view shows it, and surface formats contain it.</source>
        <translation>从文件载入精细的、可带纹理的表面：它随实体变形，显示在视图中，并写入各种表面格式。</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>移除蒙皮</translation>
    </message>
    <message>
        <source>Shows and exports the solid with its own surface again.</source>
        <translation>重新以实体自身的表面显示和导出。</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>蒙皮</translation>
    </message>
</context>
<context>
    <name>wend::ModeRow</name>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>How large the picture is shown; a click shows its pixels as they are.</source>
        <translation>图像的显示比例；点击后按原始像素显示。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Export what is shown as a picture, film, sequence, ST map, mesh or view</source>
        <translation>导出所显示的内容：图片、影片、序列、ST 贴图、网格或视图</translation>
    </message>
</context>
<context>
    <name>wend::MotionChooser</name>
    <message>
        <source>Apply Motion of Another Project</source>
        <translation>应用另一项目的动作</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>项目 (*.wend)</translation>
    </message>
    <message>
        <source>This motion cannot be applied. %1</source>
        <translation>无法应用此动作。%1</translation>
    </message>
    <message>
        <source>Apply motion of %1</source>
        <translation>应用 %1 的动作</translation>
    </message>
</context>
<context>
    <name>wend::Offers</name>
    <message>
        <source>This picture fills its frame. If its border is held, it bends inside and no gap opens at the edges.</source>
        <translation>这张图片充满画框。固定边缘后只在内部变形，边上不会露出空隙。</translation>
    </message>
    <message>
        <source>Hold the Border</source>
        <translation>固定图片边缘</translation>
    </message>
    <message>
        <source>Soft edges or shadows of this picture reach beyond the cut-out, and are cut off.</source>
        <translation>这张图片的柔边或阴影超出了抠图范围，会被裁掉。</translation>
    </message>
    <message>
        <source>Include Them</source>
        <translation>一并保留</translation>
    </message>
    <message>
        <source>This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they enclose, too.</source>
        <translation>这幅图像主要由细线组成，只有线条会弯曲。填充孔洞后，线条所围的内部也会弯曲。</translation>
    </message>
    <message>
        <source>Fill the Holes</source>
        <translation>填充孔洞</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n 张图片已作为部件打开:各自弯曲。请在“部件”中将它们在相接处连接。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layers were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n 个图层已作为部件打开:各自弯曲。请在“部件”中将它们在相接处连接。</numerusform>
        </translation>
    </message>
    <message>
        <source>Open Flattened</source>
        <translation>合并打开</translation>
    </message>
    <message>
        <source>Open flattened</source>
        <translation>合并打开</translation>
    </message>
    <message>
        <source>Another Size…</source>
        <translation>其他大小…</translation>
    </message>
    <message>
        <source>This drawing became a picture of %1 × %2 pixels.</source>
        <translation>此绘图已成为 %1 × %2 像素的图像。</translation>
    </message>
</context>
<context>
    <name>wend::OpeningNote</name>
    <message>
        <source>Opening %1 …</source>
        <translation>正在打开 %1…</translation>
    </message>
</context>
<context>
    <name>wend::OptionRow</name>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
</context>
<context>
    <name>wend::PaintPanel</name>
    <message>
        <source>How many times stiffer the painted part is along its direction; ×1 is the same as everywhere.</source>
        <translation>绘制部分沿其方向的刚度是几倍；×1 与别处相同。</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>刚度方向</translation>
    </message>
    <message>
        <source>The direction at rest, which turns with the shape: the stroke&apos;s own, the one that is there, an axis, numbers, or the path of the selected pin where it is nearest.</source>
        <translation>变形前的方向，随形状转动：笔画的方向、原有方向、轴、数值，或所选图钉的路径在最近处的方向。</translation>
    </message>
    <message>
        <source>Direction in numbers</source>
        <translation>以数值表示的方向</translation>
    </message>
    <message>
        <source>At rest; its length does not matter.</source>
        <translation>变形前的方向；其长度无关紧要。</translation>
    </message>
    <message>
        <source>St&amp;iffness</source>
        <translation>刚度(&amp;I)</translation>
    </message>
    <message>
        <source>Di&amp;rection</source>
        <translation>方向(&amp;R)</translation>
    </message>
    <message>
        <source>along the stroke</source>
        <translation>沿笔画</translation>
    </message>
    <message>
        <source>as it is there</source>
        <translation>沿原有方向</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>沿 X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>沿 Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>沿 Z</translation>
    </message>
    <message>
        <source>as numbers</source>
        <translation>按数值</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>沿视线</translation>
    </message>
    <message>
        <source>along the pin&apos;s path</source>
        <translation>沿图钉路径</translation>
    </message>
    <message>
        <source>What the brush paints</source>
        <translation>画笔绘制的内容</translation>
    </message>
    <message>
        <source>The brush paints</source>
        <translation>画笔绘制</translation>
    </message>
</context>
<context>
    <name>wend::PartList</name>
    <message>
        <source>Joint x</source>
        <translation>关节 x</translation>
    </message>
    <message>
        <source>Joint y</source>
        <translation>关节 y</translation>
    </message>
    <message>
        <source>Move joint</source>
        <translation>移动关节</translation>
    </message>
    <message>
        <source>Where the part turns at rest, in pixels from the upper left corner: a point in both parts, marked by a ring on the picture.</source>
        <translation>静止时部件旋转的位置，以左上角为原点的像素：同时在两个部件内的一点，在图片上用圆环标出。</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>rides on %1</source>
        <translation>跟随 %1</translation>
    </message>
    <message>
        <source>joined to %1</source>
        <translation>连接到 %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Opac&amp;ity</source>
        <translation>不透明度(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Joined to</source>
        <translation>连接到(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Rides on</source>
        <translation>跟随(&amp;R)</translation>
    </message>
    <message>
        <source>Parts of the picture</source>
        <translation>图片的部件</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前移</translation>
    </message>
    <message>
        <source>Brings the part in front of the next one (Alt+Up).</source>
        <translation>将部件移到下一个部件之前(Alt+上)。</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>后移</translation>
    </message>
    <message>
        <source>Brings the part behind the next one (Alt+Down).</source>
        <translation>将部件移到下一个部件之后(Alt+下)。</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How much is seen of the part.</source>
        <translation>部件的可见程度。</translation>
    </message>
    <message>
        <source>Joined to</source>
        <translation>连接到</translation>
    </message>
    <message>
        <source>Welds the part to another one in the middle of where they overlap at rest: it turns there, and pulls nothing else.</source>
        <translation>在静止时重叠处的中央与另一部件连接:它在那里转动,不牵动其他部分。</translation>
    </message>
    <message>
        <source>Rides on</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>The part follows the motion of another one, as eyes do on a face.</source>
        <translation>部件跟随另一部件的运动,如脸上的眼睛。</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>更改不透明度</translation>
    </message>
    <message>
        <source>Choose a part that is not in front.</source>
        <translation>请选择一个不在最前面的部件。</translation>
    </message>
    <message>
        <source>Choose a part that is not at the back.</source>
        <translation>请选择一个不在最后面的部件。</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>隐藏部件</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>显示部件</translation>
    </message>
    <message>
        <source>Another part has this name.</source>
        <translation>另一个部件已使用此名称。</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>重命名部件</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>更改顺序</translation>
    </message>
    <message>
        <source>These parts do not overlap at rest: there is no place for a joint.</source>
        <translation>这些部件在静止时没有重叠:没有放置关节的位置。</translation>
    </message>
    <message>
        <source>Remove joint</source>
        <translation>移除关节</translation>
    </message>
    <message>
        <source>Join parts</source>
        <translation>连接部件</translation>
    </message>
    <message>
        <source>Change what a part rides on</source>
        <translation>更改部件的跟随对象</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>正片叠底</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>滤色</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>相加</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>&amp;Blend mode</source>
        <translation>混合模式(&amp;B)</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>混合模式</translation>
    </message>
    <message>
        <source>How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen and Add lighten, as light does.</source>
        <translation>部件如何与其下方的内容合成：正片叠底像阴影一样变暗；滤色和相加像光一样变亮。</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>更改混合模式</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>柔和边缘(&amp;F)</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>柔和边缘</translation>
    </message>
    <message>
        <source>How wide the edge is along which the part was cut out. The colours of what is behind it are removed from it.</source>
        <translation>部件被剪切处边缘的宽度。其后面内容的颜色会从边缘去除。</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>更改柔和边缘</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies in front; click its eye to hide it; the lock at its end protects it from changes; a double-click changes its name.</source>
        <translation>最前面的部件排在第一。拖动部件或按 Alt 加方向键可改变前后顺序;点击眼睛可隐藏;行尾的锁可防止更改;双击可更改名称。</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>The part is seen, but clicks go through it, and it is neither painted nor are its pins moved.</source>
        <translation>部件可见,但单击会穿过它;它不会被绘制,其图钉也不会移动。</translation>
    </message>
    <message>
        <source>Choose a part.</source>
        <translation>请选择一个部件。</translation>
    </message>
    <message>
        <source>Lock part</source>
        <translation>锁定部件</translation>
    </message>
    <message>
        <source>Unlock part</source>
        <translation>解锁部件</translation>
    </message>
</context>
<context>
    <name>wend::PartOrderRow</name>
    <message>
        <source>In Front from Here</source>
        <translation>从此处起在前</translation>
    </message>
    <message>
        <source>From the shown time on the part is in front of all others; before, it stays where it is.</source>
        <translation>从显示的时间起，此部件位于所有其他部件之前；之前保持不变。</translation>
    </message>
    <message>
        <source>Behind from Here</source>
        <translation>从此处起在后</translation>
    </message>
    <message>
        <source>From the shown time on the part is behind all others; before, it stays where it is.</source>
        <translation>从显示的时间起，此部件位于所有其他部件之后；之前保持不变。</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>Removes all changes of the order of this part.</source>
        <translation>移除此部件的所有顺序更改。</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>保持顺序</translation>
    </message>
    <message>
        <source>In front from here on</source>
        <translation>从此处起在前</translation>
    </message>
    <message>
        <source>Behind from here on</source>
        <translation>从此处起在后</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Changes at %1</source>
        <translation>在 %1 更改</translation>
    </message>
</context>
<context>
    <name>wend::PictureActions</name>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>What you draw will bend, too; Ctrl takes it away instead</source>
        <translation>所画部分也要变形；按住 Ctrl 减去</translation>
    </message>
    <message>
        <source>&amp;Take Away</source>
        <translation>减去(&amp;T)</translation>
    </message>
    <message>
        <source>What you draw will not bend; Ctrl adds it instead</source>
        <translation>所画部分不变形；按住 Ctrl 添加</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen; also [ and ]</source>
        <translation>画笔在屏幕上的宽度；也可用 [ 和 ]</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much colours may differ; this also changes the last click. Also [ and ]</source>
        <translation>颜色可以相差多少，对最后一次单击也有效；也可用 [ 和 ]</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>制作部件(&amp;P)</translation>
    </message>
    <message>
        <source>What you draw becomes a part that bends by itself; what is behind it is filled</source>
        <translation>您绘制的区域将成为独立弯曲的部件；其后方会被填充</translation>
    </message>
</context>
<context>
    <name>wend::PictureDialog</name>
    <message>
        <source>%1 has no transparency: the background is that of the view.</source>
        <translation>%1 不支持透明：背景与视图相同。</translation>
    </message>
    <message>
        <source>&amp;Proportions of the view</source>
        <translation>视图的宽高比(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>透明背景(&amp;T)</translation>
    </message>
    <message>
        <source>P&amp;ins and axes</source>
        <translation>图钉和轴(&amp;I)</translation>
    </message>
    <message>
        <source>Export View</source>
        <translation>导出视图</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>要导出的文件类型。</translation>
    </message>
    <message>
        <source>Proportions of the view</source>
        <translation>视图的宽高比</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the view shows.</source>
        <translation>宽度和高度联动，使图片与视图所示相同。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>图片的宽度，以像素计。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of the picture in pixels; it decides how large the solid is.</source>
        <translation>图片的高度，以像素计；它决定实体的大小。</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>透明背景</translation>
    </message>
    <message>
        <source>Only the solid, without a background.</source>
        <translation>只有实体，没有背景。</translation>
    </message>
    <message>
        <source>Pins and axes</source>
        <translation>图钉和轴</translation>
    </message>
    <message>
        <source>Pins, their paths and the axes, as large as in the window.</source>
        <translation>图钉、其路径和轴，与窗口中一样大。</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>格式(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>Width and height must be between %1 and %2 pixels.</source>
        <translation>宽度和高度必须介于 %1 和 %2 像素之间。</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>&amp;Legend of the overlay</source>
        <translation>叠加层图例(&amp;L)</translation>
    </message>
    <message>
        <source>Legend of the overlay</source>
        <translation>叠加层图例</translation>
    </message>
    <message>
        <source>The colours of the overlay and their values.</source>
        <translation>叠加层的颜色及其数值。</translation>
    </message>
    <message>
        <source>Show the colour overlay first: it has the legend.</source>
        <translation>请先显示颜色叠加：图例属于它。</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>导出影片</translation>
    </message>
</context>
<context>
    <name>wend::PictureKeeper</name>
    <message>
        <source>The picture “%1” was changed by another program.</source>
        <translation>图片“%1”已被其他程序更改。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新载入</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Reload picture</source>
        <translation>重新载入图片</translation>
    </message>
    <message>
        <source>Replace Picture</source>
        <translation>替换图片</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>Replace picture</source>
        <translation>替换图片</translation>
    </message>
    <message>
        <source>The picture cannot be read. %1</source>
        <translation>无法读取图片。%1</translation>
    </message>
    <message>
        <source>It has %1 × %2 pixels, and the picture before had %3 × %4.</source>
        <translation>它为 %1 × %2 像素，之前的图片为 %3 × %4。</translation>
    </message>
    <message>
        <source>This picture has other proportions. %1</source>
        <translation>此图片的比例不同。%1</translation>
    </message>
    <message>
        <source>The picture has other proportions now. %1</source>
        <translation>图片的比例已改变。%1</translation>
    </message>
    <message>
        <source>Pins and paths are scaled with it. %1</source>
        <translation>图钉和路径已随之缩放。%1</translation>
    </message>
    <message>
        <source>Change drawing size</source>
        <translation>更改绘图大小</translation>
    </message>
</context>
<context>
    <name>wend::PinActions</name>
    <message>
        <source>&amp;Pins</source>
        <translation>图钉(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>锁定(&amp;L)</translation>
    </message>
    <message>
        <source>The selected pins are neither moved nor removed until unlocked</source>
        <translation>所选图钉在解锁之前不能移动，也不能移除</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>The selected pins still hold, but are neither drawn nor picked</source>
        <translation>所选图钉仍起作用，但不显示，也无法选取</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>全部显示(&amp;S)</translation>
    </message>
    <message>
        <source>Show all hidden pins again</source>
        <translation>重新显示所有隐藏的图钉</translation>
    </message>
    <message>
        <source>Alt+Shift+H</source>
        <translation>Alt+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Group…</source>
        <translation>编组(&amp;G)…</translation>
    </message>
    <message>
        <source>Put the selected pins under a heading of the list</source>
        <translation>将所选图钉归到列表的一个标题下</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>取消编组(&amp;U)</translation>
    </message>
    <message>
        <source>Take the selected pins out of their groups</source>
        <translation>将所选图钉移出其所在的组</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Lin&amp;k</source>
        <translation>链接(&amp;K)</translation>
    </message>
    <message>
        <source>The selected pins move together, whichever of them is dragged</source>
        <translation>无论拖动其中哪一个，所选图钉都一起移动</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>镜像(&amp;M)</translation>
    </message>
    <message>
        <source>Set pins at the mirror images of the selected ones, across the middle of the shape, with mirrored motions</source>
        <translation>以形状中央为镜面，在所选图钉的对称位置放置图钉，其运动也成镜像</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Mirror M&amp;otion</source>
        <translation>镜像运动(&amp;O)</translation>
    </message>
    <message>
        <source>The selected pins move to the other side instead</source>
        <translation>使所选图钉改为朝另一侧移动</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红色</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫色</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>棕色</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>青绿色</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>梅红色</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>By &amp;Place in the List</source>
        <translation>按在列表中的位置(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>其他(&amp;O)…</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>请先选择图钉。</translation>
    </message>
    <message>
        <source>The selected pin is in no group.</source>
        <translation>所选图钉不在任何组中。</translation>
    </message>
    <message>
        <source>Select several pins first.</source>
        <translation>请先选择多个图钉。</translation>
    </message>
    <message>
        <source>Select a pin that moves.</source>
        <translation>请选择一个会移动的图钉。</translation>
    </message>
    <message>
        <source>No pin is hidden.</source>
        <translation>没有隐藏的图钉。</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>编组</translation>
    </message>
    <message>
        <source>Name of the group:</source>
        <translation>组名称：</translation>
    </message>
    <message>
        <source>Colour of the Pin</source>
        <translation>图钉颜色</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Mo&amp;ve</source>
        <translation>移动(&amp;V)</translation>
    </message>
    <message>
        <source>Drag pins to move them; in a solid, also by the arrows</source>
        <translation>拖动图钉可移动它们；实体还可拖动箭头</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>旋转(&amp;R)</translation>
    </message>
    <message>
        <source>Drag to rotate the selected pins; in a solid, by the rings</source>
        <translation>拖动可旋转所选图钉；实体请拖动圆环</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>缩放(&amp;A)</translation>
    </message>
    <message>
        <source>Drag to scale the selected pins; in a solid, by the ring</source>
        <translation>拖动可缩放所选图钉；实体请拖动圆环</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>请先打开图片。</translation>
    </message>
    <message>
        <source>Select &amp;Pins</source>
        <translation>选择图钉(&amp;P)</translation>
    </message>
    <message>
        <source>What the pin tool and the select tool draw around pins to select them</source>
        <translation>用图钉或选择工具在图钉旁拖动进行选择时所画的形状</translation>
    </message>
    <message>
        <source>By &amp;Rectangle</source>
        <translation>矩形(&amp;R)</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>By &amp;Lasso</source>
        <translation>套索(&amp;L)</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>By &amp;Brush</source>
        <translation>画笔(&amp;B)</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>吸附(&amp;N)</translation>
    </message>
    <message>
        <source>New pins sit on corners of the mesh instead of where you click</source>
        <translation>将新图钉放在网格顶点上，而不是单击处</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ].</source>
        <translation>画笔在屏幕上的直径；也可用 [ 和 ] 键更改。</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pin for the Whole &amp;Animation</source>
        <translation>固定整个动画(&amp;A)</translation>
    </message>
    <message>
        <source>The selected pins hold from the start of the animation to its end, not only from the time at which they were set</source>
        <translation>所选图钉从动画开始到结束一直固定，而不只是从设置时起</translation>
    </message>
    <message>
        <source>The selected pin already holds for the whole animation.</source>
        <translation>所选图钉已在整个动画中固定。</translation>
    </message>
</context>
<context>
    <name>wend::PinList</name>
    <message>
        <source>Pins</source>
        <translation>图钉</translation>
    </message>
    <message>
        <source>Does not hold at the time shown.</source>
        <translation>在当前显示的时刻不起作用。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow keys move them. The eye hides, the lock protects from changes; a right-click groups, links and mirrors.</source>
        <translation>在此选择图钉；F2 重命名，Delete 移除，按 Enter 转到图片，可用方向键移动图钉。眼睛图标用于隐藏，锁图标用于防止更改；右键单击可编组、链接和镜像。</translation>
    </message>
    <message>
        <source>Moves together with others</source>
        <translation>与其他图钉一起移动</translation>
    </message>
    <message>
        <source>Hidden: a click shows it</source>
        <translation>已隐藏：单击显示</translation>
    </message>
    <message>
        <source>A click hides it</source>
        <translation>单击隐藏</translation>
    </message>
    <message>
        <source>Locked: a click unlocks it</source>
        <translation>已锁定：单击解锁</translation>
    </message>
    <message>
        <source>A click locks it</source>
        <translation>单击锁定</translation>
    </message>
    <message>
        <source>No pins yet</source>
        <translation>还没有图钉</translation>
    </message>
</context>
<context>
    <name>wend::ProblemRemedies</name>
    <message>
        <source>Use Multigrid</source>
        <translation>使用多重网格</translation>
    </message>
    <message>
        <source>Half as Many Vertices</source>
        <translation>顶点减半</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>wend::Properties</name>
    <message>
        <source>Advanced</source>
        <translation>高级</translation>
    </message>
    <message>
        <source>The same in numbers, for those who want them.</source>
        <translation>同样的设置，以数值指定。</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>精细度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>图钉</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流动</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Size, area, volume and edges, the quality of the cells, and gaps that a cage closes.</source>
        <translation>尺寸、面积、体积和边，单元质量，以及笼子封闭的缝隙。</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组</translation>
    </message>
</context>
<context>
    <name>wend::PropertiesRail</name>
    <message>
        <source>Opens this part of the properties over the view; Esc closes it.</source>
        <translation>在视图上打开属性的这一部分；按 Esc 关闭。</translation>
    </message>
</context>
<context>
    <name>wend::ReachRow</name>
    <message>
        <source>Pull reaches</source>
        <translation>拉力范围</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads. Near: close to the pin, sharp. Far: soft and wide.</source>
        <translation>图钉的拉力扩散多远。近：靠近图钉，锐利。远：柔和而宽广。</translation>
    </message>
    <message>
        <source>Pull &amp;reaches</source>
        <translation>拉力范围(&amp;R)</translation>
    </message>
    <message>
        <source>near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>此项目按论文的方式用 λ 平滑；程度由其文件给出。</translation>
    </message>
</context>
<context>
    <name>wend::RegionList</name>
    <message>
        <source>The mesh is equally fine everywhere: brush over what should be finer or coarser.</source>
        <translation>网格处处同样精细：用画笔刷过要更细或更粗的部分。</translation>
    </message>
    <message>
        <source>Nothing has an order of its own: brush over what should lie in front or behind.</source>
        <translation>没有部分有自己的次序：用画笔刷过要在前或在后的部分。</translation>
    </message>
    <message>
        <source>Where the mesh is finer or coarser</source>
        <translation>网格更细或更粗之处</translation>
    </message>
    <message>
        <source>What lies in front</source>
        <translation>位于前面的部分</translation>
    </message>
    <message>
        <source>The strokes and regions so far; where two overlap, the upper one counts. A click shows where it lies and its number, a double-click changes its name.</source>
        <translation>现有的笔触和区域；同一处有两个时，以上面的为准。单击显示其位置和数值，双击更改名称。</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>次序</translation>
    </message>
    <message>
        <source>How long edges are there, compared with elsewhere: less is finer, more is coarser.</source>
        <translation>该处的边长，相对于别处：越小越细，越大越粗。</translation>
    </message>
    <message>
        <source>Greater than 0 lies in front, less than 0 behind.</source>
        <translation>大于 0 在前，小于 0 在后。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes the chosen region.</source>
        <translation>移除所选的区域。</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>更细与更粗</translation>
    </message>
    <message>
        <source>In front and behind</source>
        <translation>前与后</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>边长(&amp;D)</translation>
    </message>
    <message>
        <source>O&amp;rder</source>
        <translation>次序(&amp;R)</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>更改边长</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>更改次序</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>移除区域</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>一侧</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>重命名区域</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>添加区域</translation>
    </message>
    <message>
        <source>A ball, a box or a half-space in the middle, or what the selected handle holds as a region; its numbers can then be changed.</source>
        <translation>位于中央的球体、长方体或半空间，或所选手柄抓取的区域；之后可更改其数值。</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>羽化</translation>
    </message>
    <message>
        <source>Over what width the size blends into that around it, in the file&apos;s units.</source>
        <translation>尺寸过渡到周围尺寸的宽度，以文件单位计。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>半空间</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>Region of the selected handle</source>
        <translation>所选手柄的区域</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>羽化(&amp;G)</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>更改区域</translation>
    </message>
    <message>
        <source>Add size region</source>
        <translation>添加尺寸区域</translation>
    </message>
    <message>
        <source>First select a pin that holds a ball, a box or one side.</source>
        <translation>请先选择抓取球、块或单侧的图钉。</translation>
    </message>
    <message>
        <source>Beneath them: the factors in %1.</source>
        <translation>在其之下：%1 中的系数。</translation>
    </message>
    <message>
        <source>The surface&apos;s triangles are kept, and only the inside changes. “Refine surface” in the panel “Mesh” allows them to be split, too.</source>
        <translation>表面的三角形保持不变，只有内部改变。“网格”面板中的“细分表面”也允许分割它们。</translation>
    </message>
</context>
<context>
    <name>wend::RegionNumbers</name>
    <message>
        <source>Numbers of the region</source>
        <translation>区域的数值</translation>
    </message>
    <message>
        <source>As x, y and z, in the coordinates of the rest shape.</source>
        <translation>以 x、y、z 表示，采用原始形状的坐标。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>半空间</translation>
    </message>
    <message>
        <source>Kind of region</source>
        <translation>区域类型</translation>
    </message>
    <message>
        <source>What the region is; another kind keeps its place.</source>
        <translation>区域的类型；更换类型时位置不变。</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>区域(&amp;R)</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>from</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>point of the plane</source>
        <translation>平面上的点</translation>
    </message>
    <message>
        <source>to</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>direction into it</source>
        <translation>指向内部的方向</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>The radius of the ball.</source>
        <translation>球体的半径。</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>半径(&amp;D)</translation>
    </message>
</context>
<context>
    <name>wend::RegionPanel</name>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>There is no vertex in this region: nothing was changed.</source>
        <translation>此区域中没有顶点：未作任何更改。</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>更改区域</translation>
    </message>
    <message numerus="yes">
        <source>Vertices: %n</source>
        <translation>
            <numerusform>%n 个顶点</numerusform>
        </translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>半径(&amp;D)</translation>
    </message>
    <message>
        <source>Holds its a&amp;ngle</source>
        <translation>保持角度(&amp;H)</translation>
    </message>
    <message>
        <source>How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. In the shape&apos;s own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does the same.</source>
        <translation>图钉固定周围形状的范围：0 固定一个点，更大则固定一个圆，在实体中为球。以形状自身的单位计，图片为像素。用 Ctrl 和 Shift 拖动图钉效果相同。</translation>
    </message>
    <message>
        <source>The pin keeps the angle that the picture has there now, as a small circle; without it, the picture turns freely around the pin.</source>
        <translation>图钉以小圆的形式保持图片此处当前的角度；否则图片可绕图钉自由旋转。</translation>
    </message>
</context>
<context>
    <name>wend::RidingOffer</name>
    <message>
        <source>A part has no pin and stays behind: let it ride on “%1”?</source>
        <translation>一个部件没有图钉而留在原处：让它跟随“%1”吗？</translation>
    </message>
    <message>
        <source>A part has no pin and stays behind: let it ride on what is beside it?</source>
        <translation>一个部件没有图钉而留在原处：让它跟随旁边的内容吗？</translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on “%1”?</source>
        <translation>
            <numerusform>%n 个部件没有图钉而留在原处：让它们跟随“%1”吗？</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on what is beside them?</source>
        <translation>
            <numerusform>%n 个部件没有图钉而留在原处：让它们跟随旁边的内容吗？</numerusform>
        </translation>
    </message>
    <message>
        <source>Let parts ride</source>
        <translation>让部件跟随</translation>
    </message>
    <message>
        <source>Let It Ride</source>
        <translation>让它跟随</translation>
    </message>
    <message>
        <source>Let Them Ride</source>
        <translation>让它们跟随</translation>
    </message>
</context>
<context>
    <name>wend::ShapeCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation>图片及其图钉</translation>
    </message>
</context>
<context>
    <name>wend::ShapeNotices</name>
    <message>
        <source>“Refine surface” in the panel “Mesh” allows the surface&apos;s triangles to be split.</source>
        <translation>“网格”面板中的“细分表面”允许分割表面的三角形。</translation>
    </message>
    <message>
        <source>Pin It</source>
        <translation>用图钉固定</translation>
    </message>
    <message>
        <source>A part is joined to the rest at a single point, and may swing around it unless a pin holds it.</source>
        <translation>有一部分只以一点与其余相连，若没有图钉固定，可能会绕该点摆动。</translation>
    </message>
    <message numerus="yes">
        <source>%n parts are joined to the rest at single points, and may swing around them unless pins hold them.</source>
        <translation>
            <numerusform>有 %n 个部分只以一点与其余相连，若没有图钉固定，可能会绕该点摆动。</numerusform>
        </translation>
    </message>
    <message>
        <source>See Why</source>
        <translation>查看原因</translation>
    </message>
    <message>
        <source>Fill All, with Labels</source>
        <translation>全部填充并加标签</translation>
    </message>
    <message>
        <source>Leave Holes</source>
        <translation>保留孔洞</translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>Widen %1</source>
        <translation>扩大 %1</translation>
    </message>
    <message>
        <source>%1 cannot go further: %2</source>
        <translation>%1 无法再移动：%2</translation>
    </message>
    <message>
        <source>Cancelled: everything is as it was before the last change.</source>
        <translation>已取消：一切恢复到上次更改之前。</translation>
    </message>
    <message>
        <source>Meshing was cancelled. Any change, such as fewer vertices, starts it again.</source>
        <translation>网格划分已取消。任何更改都会重新划分网格，例如减少顶点数。</translation>
    </message>
    <message>
        <source>The motion was cancelled. Any change computes it again.</source>
        <translation>运动计算已取消。任何更改都会重新计算。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>No pin was set: this place lies outside the shape.</source>
        <translation>没有放置图钉：此处在形状之外。</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>%1 does not hold the shape at the time shown.</source>
        <translation>%1 在当前显示的时刻不起作用。</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>缩放 %1</translation>
    </message>
    <message>
        <source>This replaces what came after; Undo brings it back.</source>
        <translation>此后的内容已被替换；撤销可恢复。</translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation>
            <numerusform>%n 个图钉</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1（镜像）</translation>
    </message>
    <message>
        <source>No pin was set where the mirror image lies outside the shape.</source>
        <translation>镜像落在形状之外的地方不放置图钉。</translation>
    </message>
    <message>
        <source>There is already a pin where the mirror image would be.</source>
        <translation>镜像所在的位置已有图钉。</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>镜像 %1</translation>
    </message>
    <message>
        <source>Mirror the motion of %1</source>
        <translation>镜像 %1 的运动</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>锁定 %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>解锁 %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>取消 %1 的编组</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>将 %1 编组</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>重命名组</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>更改 %1 的颜色</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>链接 %1</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>取消 %1 的链接</translation>
    </message>
    <message>
        <source>%1 is locked. A right-click or the list of pins unlocks it.</source>
        <translation>%1 已锁定。可通过右键单击或图钉列表解锁。</translation>
    </message>
    <message>
        <source>%1 are locked. A right-click or the list of pins unlocks them.</source>
        <translation>%1 已锁定。可通过右键单击或图钉列表解锁。</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>录制 %1</translation>
    </message>
    <message>
        <source>Recorded. K plays it; record other pins from the same time, and they move together.</source>
        <translation>已录制。按 K 播放；从同一时刻录制其他图钉，它们会一起运动。</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>图钉</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>编辑路径</translation>
    </message>
    <message>
        <source>Draw the path of %1</source>
        <translation>绘制%1的路径</translation>
    </message>
    <message>
        <source>K plays it; draw the paths of other pins from the same time, and they move together.</source>
        <translation>按 K 播放；从同一时刻绘制其他图钉的路径，它们会一起移动。</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>松弛</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>This replaces what %1 did later; Undo brings it back.</source>
        <translation>%1 此后的运动已被替换；撤销可恢复。</translation>
    </message>
    <message>
        <source>This circle is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>此圆比网格的格子还小：请把它调大，或把网格调细。</translation>
    </message>
    <message>
        <source>This ball is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>此球比网格的格子还小：请把它调大，或把网格调细。</translation>
    </message>
    <message>
        <source>Pin %1 for the whole animation</source>
        <translation>在整个动画中固定 %1</translation>
    </message>
    <message>
        <source>The film is longer by a second: what you had timed keeps its times.</source>
        <translation>影片延长了一秒：已设定的时间保持不变。</translation>
    </message>
    <message>
        <source>The film is longer by a second. At an earlier time a drag sets the pose there.</source>
        <translation>影片延长了一秒。在更早的时间拖动会设定那里的姿势。</translation>
    </message>
    <message>
        <source>Posed at %1 s: what comes before and after stays.</source>
        <translation>%1 秒处的姿势：前后保持不变。</translation>
    </message>
    <message>
        <source>No pose was set where a pin begins, rotates or does not hold: show another time.</source>
        <translation>在图钉开始、旋转或不固定之处没有设定姿势：请显示别的时间。</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>The last move goes straight there now. Motion ▸ Keep the Path leads pins on instead.</source>
        <translation>上一次移动现在直接到达那里。运动 ▸ 保留路径 则让图钉继续移动。</translation>
    </message>
    <message>
        <source>%1 is in a part that is locked. The list of parts unlocks it.</source>
        <translation>%1 位于已锁定的部件中。可在部件列表中解锁。</translation>
    </message>
    <message>
        <source>A part is still being made. Pins can be dragged as soon as it is there.</source>
        <translation>正在制作部件。完成后即可拖动图钉。</translation>
    </message>
    <message>
        <source>The motion stops at %1 s: %2</source>
        <translation>运动在 %1 秒处停止：%2</translation>
    </message>
</context>
<context>
    <name>wend::ShortcutDialog</name>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>标准(&amp;S)</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Search for an action or for keys</source>
        <translation>搜索操作或按键</translation>
    </message>
    <message>
        <source>&amp;All Standard</source>
        <translation>全部恢复标准(&amp;A)</translation>
    </message>
    <message>
        <source>Give every action the keys that it has in a new Wend</source>
        <translation>将所有操作恢复为 Wend 初始的按键</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Click here, then press the keys</source>
        <translation>点击此处，然后按下按键</translation>
    </message>
    <message>
        <source>Leave the chosen action without keys</source>
        <translation>使所选操作没有按键</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it has in a new Wend</source>
        <translation>将所选操作恢复为 Wend 初始的按键</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Choose an action, then press the keys that it shall have.</source>
        <translation>选择一个操作，然后按下要指定的按键。</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: the canvas uses it.</source>
        <translation>无法选择 %1：画布正在使用它。</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>已从%1移除。</translation>
    </message>
</context>
<context>
    <name>wend::SideWindows</name>
    <message>
        <source>As it was opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>What was done; a click goes back or forward to that step.</source>
        <translation>做过的操作；单击可后退或前进到该步。</translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation>关于 Wend</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;让图片和实体如流动般变形。&lt;/p&gt;&lt;p&gt;基于以下论文：J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;自由软件，依据 GNU Affero General Public License 第 3 版或更新版本发布。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
</context>
<context>
    <name>wend::SolidActions</name>
    <message>
        <source>Through the &amp;Solid</source>
        <translation>穿透实体(&amp;S)</translation>
    </message>
    <message>
        <source>Rectangle, lasso and brush also take or select what is hidden</source>
        <translation>矩形、套索和画笔也抓取或选择被遮挡的部分</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Grab Beyond the &amp;Cut</source>
        <translation>抓取剖切掉的一侧(&amp;C)</translation>
    </message>
    <message>
        <source>Take hold of all that the cut takes away, as one handle</source>
        <translation>将剖切去掉的全部内容抓取为一个手柄</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>蒙皮(&amp;K)</translation>
    </message>
    <message>
        <source>Show the detailed or textured surface embedded in the solid; off: the border of the tetrahedra, which bend</source>
        <translation>显示随实体变形的精细或带纹理的表面；关闭时显示变形的四面体的边界</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Choose Sk&amp;in…</source>
        <translation>选择蒙皮(&amp;I)…</translation>
    </message>
    <message>
        <source>Embed a detailed, perhaps textured surface from a file in the solid</source>
        <translation>让文件中精细的、可带纹理的表面随实体变形</translation>
    </message>
    <message>
        <source>Re&amp;move Skin</source>
        <translation>移除蒙皮(&amp;M)</translation>
    </message>
    <message>
        <source>Show and export the solid with its own surface again</source>
        <translation>重新以实体自身的表面显示和导出</translation>
    </message>
    <message>
        <source>&amp;Flat Faces</source>
        <translation>平直着色(&amp;F)</translation>
    </message>
    <message>
        <source>Shade every triangle by itself instead of smoothly</source>
        <translation>逐个三角形着色，而非平滑着色</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Parallel View</source>
        <translation>平行投影(&amp;P)</translation>
    </message>
    <message>
        <source>See without perspective</source>
        <translation>不带透视地查看</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>&amp;Cut Open</source>
        <translation>剖开(&amp;C)</translation>
    </message>
    <message>
        <source>Look inside along a plane; an arrow and rings move and tilt it</source>
        <translation>沿平面查看内部；箭头移动平面，圆环使其倾斜</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Look along an axis of the world</source>
        <translation>沿世界坐标轴观察</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前(&amp;F)</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右(&amp;R)</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上(&amp;T)</translation>
    </message>
    <message>
        <source>7</source>
        <translation>7</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>下(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>斜向(&amp;O)</translation>
    </message>
    <message>
        <source>Look from the side and above</source>
        <translation>从侧上方观察</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>&amp;Wend</source>
        <translation>Wend(&amp;W)</translation>
    </message>
    <message>
        <source>Right or middle button turns, with Shift moves; the wheel zooms</source>
        <translation>右键或中键旋转，加 Shift 平移；滚轮缩放</translation>
    </message>
    <message>
        <source>Like &amp;VTK</source>
        <translation>类似 VTK(&amp;V)</translation>
    </message>
    <message>
        <source>Left button turns, middle moves, right zooms, as in ParaView</source>
        <translation>左键旋转，中键平移，右键缩放，与 ParaView 相同</translation>
    </message>
    <message>
        <source>Like &amp;Blender</source>
        <translation>类似 Blender(&amp;B)</translation>
    </message>
    <message>
        <source>Middle button turns, with Shift moves, with Ctrl zooms</source>
        <translation>中键旋转，加 Shift 平移，加 Ctrl 缩放</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>实体(&amp;S)</translation>
    </message>
    <message>
        <source>L&amp;ook from</source>
        <translation>视角(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>导航(&amp;N)</translation>
    </message>
    <message>
        <source>The solid has neither a detailed surface nor materials.</source>
        <translation>此实体既没有精细表面，也没有材质。</translation>
    </message>
    <message>
        <source>No detailed surface was chosen for the solid.</source>
        <translation>尚未为此实体选择精细表面。</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>网格来自文件，按原样使用。</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>请先打开实体。</translation>
    </message>
    <message>
        <source>Which axis of the world points up in the view; kept with the project</source>
        <translation>视图中哪个世界轴朝上；随项目保存</translation>
    </message>
    <message>
        <source>&amp;X Points Up</source>
        <translation>X 轴朝上(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Y Points Up</source>
        <translation>Y 轴朝上(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Z Points Up</source>
        <translation>Z 轴朝上(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>向上的轴(&amp;U)</translation>
    </message>
</context>
<context>
    <name>wend::SolidCanvas</name>
    <message>
        <source>there is not enough memory for a picture of %1 x %2 pixels</source>
        <translation>内存不足以生成 %1 x %2 像素的图片</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>正在导出图片…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>单元 %1</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>正在导出影片…</translation>
    </message>
</context>
<context>
    <name>wend::SolidWorkshop</name>
    <message>
        <source>Solids need OpenGL 3.3, which this system does not have. The command line (wend run) still works with them.</source>
        <translation>实体需要 OpenGL 3.3，而此系统不支持。命令行（wend run）仍可处理实体。</translation>
    </message>
    <message>
        <source>These pictures of the surface cannot be read: %1</source>
        <translation>无法读取表面的这些图片：%1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已导出：%1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>未导出任何内容。%1</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>形状仍在计算中。请稍后再试。</translation>
    </message>
</context>
<context>
    <name>wend::SoundTrack</name>
    <message>
        <source>The sound is not shown: that needs the program ffmpeg (Debian: sudo apt install ffmpeg).</source>
        <translation>无法显示声音：需要程序 ffmpeg（Debian：sudo apt install ffmpeg）。</translation>
    </message>
    <message>
        <source>The sound %1 cannot be read: is the file there?</source>
        <translation>无法读取声音 %1：文件存在吗？</translation>
    </message>
</context>
<context>
    <name>wend::SpringOffer</name>
    <message>
        <source>What comes back leaves the shape a little different, so that a loop jumps. If the shape springs back fully, it is as it was.</source>
        <translation>固定点回到原处后形状会略有不同，循环会跳动。若完全回弹，形状便与原来一样。</translation>
    </message>
    <message>
        <source>Spring Back Fully</source>
        <translation>完全回弹</translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation>钉住图片，拉出形状，让它流动。</translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation>将图片拖放到此处</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation>选择图片、平面网格或项目。</translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation>试试示例</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>Five-minute tutorial</source>
        <translation>五分钟教程</translation>
    </message>
    <message>
        <source>The first steps on a sample, one after another.</source>
        <translation>用示例逐一学习最初的步骤。</translation>
    </message>
    <message>
        <source>Not saved when Wend ended</source>
        <translation>Wend 结束时未保存</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>放弃…</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>放弃 %1</translation>
    </message>
    <message>
        <source>Deletes these changes for good.</source>
        <translation>永久丢弃这些更改。</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.
PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too.</source>
        <translation>支持 PNG、JPEG、TIFF、EXR、WebP 等，带透明背景的抠图效果最好。
PSD、ORA、KRA 和 SVG 连同图层一起打开。也可打开项目、网格和实体。</translation>
    </message>
</context>
<context>
    <name>wend::StatusFields</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Where the pointer is, in the picture&apos;s pixels</source>
        <translation>指针所在位置，以图片像素计</translation>
    </message>
    <message>
        <source>Area change</source>
        <translation>面积变化</translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation>形状比变形前大了或小了多少</translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation>面积 %1%</translation>
    </message>
    <message>
        <source>volume %1 %</source>
        <translation>体积 %1%</translation>
    </message>
</context>
<context>
    <name>wend::SurfaceCheck</name>
    <message>
        <source>Triangles with missing points</source>
        <translation>缺少顶点的三角形</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>相交的三角形</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Edges of more than two</source>
        <translation>由两个以上三角形共用的边</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>面积为零的三角形</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>重复的三角形</translation>
    </message>
    <message>
        <source>Turned neighbours</source>
        <translation>朝向相反的相邻三角形</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>所有点都在同一平面上。</translation>
    </message>
    <message>
        <source>Save List</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>文本 (*.txt)</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>修复表面</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>生成笼体</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>仅精确表面</translation>
    </message>
    <message>
        <source>merge points (%1)</source>
        <translation>合并点（%1）</translation>
    </message>
    <message>
        <source>drop triangles (%1)</source>
        <translation>去除三角形（%1）</translation>
    </message>
    <message>
        <source>turn triangles (%1)</source>
        <translation>翻转三角形（%1）</translation>
    </message>
    <message>
        <source>fill holes (%1)</source>
        <translation>填补孔洞（%1）</translation>
    </message>
    <message>
        <source>It would %1.</source>
        <translation>将执行：%1。</translation>
    </message>
    <message>
        <source>No simple step fixes this one.</source>
        <translation>没有简单的步骤能修正此处。</translation>
    </message>
    <message>
        <source>add triangles (%1)</source>
        <translation>添加三角形 (%1)</translation>
    </message>
    <message>
        <source>It would leave %1 of %2 faults.</source>
        <translation>%2 处问题中将剩下 %1 处。</translation>
    </message>
    <message>
        <source>Fix one fault</source>
        <translation>修正一处问题</translation>
    </message>
    <message>
        <source>No simple steps fix all of these.</source>
        <translation>没有简单的步骤能把它们全部修正。</translation>
    </message>
    <message>
        <source>Fix all faults of a kind</source>
        <translation>修正某一类的所有问题</translation>
    </message>
    <message>
        <source>Looking for what fixes all of these …</source>
        <translation>正在寻找全部修正的方法…</translation>
    </message>
</context>
<context>
    <name>wend::SurfacePanel</name>
    <message>
        <source>Show them</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>保存列表…</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>The kinds of faults, and how often each occurs.</source>
        <translation>问题的种类，以及各有多少处。</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>上一处</translation>
    </message>
    <message>
        <source>Goes to the previous place where this is wrong.</source>
        <translation>查看存在此问题的上一处。</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>下一处</translation>
    </message>
    <message>
        <source>Goes to the next place where this is wrong.</source>
        <translation>查看存在此问题的下一处。</translation>
    </message>
    <message>
        <source>Show the triangles</source>
        <translation>显示三角形</translation>
    </message>
    <message>
        <source>Colours the triangles that are wrong and shows them: what hides them is left out.</source>
        <translation>为有问题的三角形着色并查看：遮挡它们的部分会略去。</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>Writes the numbers of all wrong triangles and edges to a file.</source>
        <translation>将所有有问题的三角形和边的编号写入文件。</translation>
    </message>
    <message>
        <source>Merges coincident points, drops degenerate and duplicate triangles, orients the others and fills small holes.</source>
        <translation>合并同一位置的点，去除退化和重复的三角形，统一朝向，并填补小孔洞。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>The surface is embedded in a cage</source>
        <translation>表面随笼体变形</translation>
    </message>
    <message>
        <source>The surface bounds no solid</source>
        <translation>表面未围成实体</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>“Repair” helps.</source>
        <translation>“修复”有效。</translation>
    </message>
    <message>
        <source>“Repair” does not help: a cage around it can carry it.</source>
        <translation>“修复”无效：可用包围它的笼体来承载。</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>仅精确表面</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>生成笼体</translation>
    </message>
    <message>
        <source>Removes the cage: without a repair there is then no solid.</source>
        <translation>去掉笼体：若不修复，就没有实体。</translation>
    </message>
    <message>
        <source>Fills a cage of even cells around the surface, which is embedded in it.</source>
        <translation>在表面周围填充由均匀单元构成的笼体，表面随之变形。</translation>
    </message>
    <message>
        <source>See the repair</source>
        <translation>预览修复</translation>
    </message>
    <message>
        <source>Shows the surface as the repair would leave it: what it adds in green, what stays wrong in red.</source>
        <translation>显示修复后的表面：新增部分为绿色，仍有问题的部分为红色。</translation>
    </message>
    <message>
        <source>There is nothing that the simple repairs would change.</source>
        <translation>没有简单修复可以更改的内容。</translation>
    </message>
    <message>
        <source>Fix this one</source>
        <translation>修正此处</translation>
    </message>
    <message>
        <source>Fixes only what is shown: what it adds is green, what it takes away or turns is yellow.</source>
        <translation>只修正正在查看的一处：添加的为绿色，去除或翻转的为黄色。</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>全部修正</translation>
    </message>
    <message>
        <source>Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no more edges than chosen below.</source>
        <translation>修正此类中简单步骤能修正的全部问题，只占一步撤销；孔洞只修正边数不超过下方所选数目的。</translation>
    </message>
    <message>
        <source>“Repair” does not help: the cage carries the surface as it is.</source>
        <translation>“修复”无效：笼体按原样承载该表面。</translation>
    </message>
    <message>
        <source>One hole has %1 edges: fill up to %1</source>
        <translation>有一个孔有 %1 条边：填充到 %1</translation>
    </message>
    <message>
        <source>%1 holes have up to %2 edges: fill up to %2</source>
        <translation>%1 个孔最多有 %2 条边：填充到 %2</translation>
    </message>
    <message>
        <source>No hole is larger</source>
        <translation>没有更大的孔</translation>
    </message>
    <message>
        <source>Sets the largest hole that the repair fills to this.</source>
        <translation>将修复所填充的最大孔设为此值。</translation>
    </message>
</context>
<context>
    <name>wend::TimeRuler</name>
    <message>
        <source>Ruler</source>
        <translation>标尺</translation>
    </message>
    <message>
        <source>Drag to show another time; with Shift, mark the part that a loop repeats. A right-click counts frames, sets the frame rate, and adds markers</source>
        <translation>拖动可显示别的时间；按住 Shift 可标出循环的部分。右键可按帧计数、设定帧率、添加标记</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>移动标记</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>更改循环段</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>添加标记</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Rename Marker</source>
        <translation>重命名标记</translation>
    </message>
    <message>
        <source>Name of the marker:</source>
        <translation>标记名称：</translation>
    </message>
    <message>
        <source>Rename marker</source>
        <translation>重命名标记</translation>
    </message>
    <message>
        <source>Frame &amp;Rate</source>
        <translation>帧率(&amp;R)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Cycle &amp;from Here</source>
        <translation>循环段由此开始(&amp;F)</translation>
    </message>
    <message>
        <source>Cycle &amp;to Here</source>
        <translation>循环段到此为止(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;No Cycle</source>
        <translation>无循环段(&amp;N)</translation>
    </message>
    <message>
        <source>Remove cycle</source>
        <translation>移除循环段</translation>
    </message>
    <message>
        <source>&amp;Count Frames</source>
        <translation>按帧计数(&amp;C)</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>添加标记(&amp;M)</translation>
    </message>
    <message>
        <source>R&amp;ename Marker…</source>
        <translation>重命名标记(&amp;E)…</translation>
    </message>
    <message>
        <source>Re&amp;move Marker</source>
        <translation>移除标记(&amp;V)</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>移除标记</translation>
    </message>
    <message>
        <source>Play the &amp;Sound</source>
        <translation>播放声音(&amp;S)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Cycle: %1 to %2</source>
        <translation>循环段：%1 到 %2</translation>
    </message>
    <message>
        <source>frames at %1 fps</source>
        <translation>帧，%1 fps</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Show Key &amp;Poses</source>
        <translation>显示关键姿势(&amp;P)</translation>
    </message>
</context>
<context>
    <name>wend::TimeScale</name>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
</context>
<context>
    <name>wend::TimeStrip</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation>显示运动的哪一时刻。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>How long the film is. The poses stay as they are, however fast it goes.</source>
        <translation>影片的长度。无论快慢，姿势都不变。</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>更改时长</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>还没有任何运动：请拖动图钉。</translation>
    </message>
    <message>
        <source>%1 /</source>
        <translation>%1 /</translation>
    </message>
    <message>
        <source>Drag a pin to begin</source>
        <translation>拖动图钉即可开始</translation>
    </message>
</context>
<context>
    <name>wend::Toolbox</name>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>What bends, and how finely</source>
        <translation>变形的范围与精细度</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>图钉</translation>
    </message>
    <message>
        <source>Hold parts and drag them</source>
        <translation>抓取各部分并拖动</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>What it is made of: soft, stiff, and what is kept where</source>
        <translation>材料：柔软、坚硬，以及何处保持什么</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>How it moves in time</source>
        <translation>随时间如何运动</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>请先打开图片。</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>请先打开实体。</translation>
    </message>
    <message>
        <source>Write pictures, sequences, ST maps and meshes</source>
        <translation>导出图片、序列、ST 贴图和网格</translation>
    </message>
</context>
<context>
    <name>wend::TrackChoice</name>
    <message>
        <source>Move in time</source>
        <translation>移动时间</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>移除运动</translation>
    </message>
    <message>
        <source>Remove motions</source>
        <translation>删除动作</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>更改缓动</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>变为直线</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>简化</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>移动关键姿势</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>移动关键姿势</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>移除关键姿势</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>移除关键姿势</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>粘贴关键姿势</translation>
    </message>
    <message>
        <source>Mirror keys</source>
        <translation>镜像关键姿势</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Nothing changes: where a pin begins it is at rest, and rotations keep their course.</source>
        <translation>没有变化：图钉开始处处于静止，旋转保持原样。</translation>
    </message>
</context>
<context>
    <name>wend::TrackView</name>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>轨道</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>移动时间</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>更改时长</translation>
    </message>
    <message>
        <source>&amp;Remove Motion</source>
        <translation>移除运动(&amp;R)</translation>
    </message>
    <message>
        <source>Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears here, pin by pin.</source>
        <translation>还没有任何运动。拖动图钉，或按住 Ctrl 录制：所做的动作会按图钉列在这里。</translation>
    </message>
    <message>
        <source>Change when it holds</source>
        <translation>更改固定的时段</translation>
    </message>
    <message>
        <source>&amp;Remove Motions</source>
        <translation>删除动作(&amp;R)</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>缓动</translation>
    </message>
    <message>
        <source>&amp;Paste at the Time Shown</source>
        <translation>粘贴到所示时间(&amp;P)</translation>
    </message>
    <message>
        <source>Paste M&amp;irrored</source>
        <translation>镜像粘贴(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Straighten</source>
        <translation>变为直线(&amp;S)</translation>
    </message>
    <message>
        <source>Simplify to &amp;Keys</source>
        <translation>简化为关键姿势(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Few</source>
        <translation>少(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Some</source>
        <translation>中(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>多(&amp;M)</translation>
    </message>
    <message>
        <source>Key at %1</source>
        <translation>关键姿势：%1</translation>
    </message>
    <message>
        <source>Holds from %1 to %2</source>
        <translation>从 %1 到 %2 固定</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4</source>
        <translation>%1：%2 到 %3，%4</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>线性(&amp;L)</translation>
    </message>
    <message>
        <source>Slow &amp;before It</source>
        <translation>之前缓慢(&amp;B)</translation>
    </message>
    <message>
        <source>Slow &amp;after It</source>
        <translation>之后缓慢(&amp;A)</translation>
    </message>
    <message>
        <source>Slow on B&amp;oth Sides</source>
        <translation>前后都缓慢(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Hold to the Next</source>
        <translation>保持到下一个(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>镜像(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Remove Keys</source>
        <translation>移除关键姿势(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Remove Key</source>
        <translation>移除关键姿势(&amp;R)</translation>
    </message>
    <message>
        <source>A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right another time, with Alt they move the chosen bar or keys</source>
        <translation>每个图钉一行，每个运动一条；上下键选择图钉，左右键更改时间，按住 Alt 移动所选的条或关键姿势</translation>
    </message>
    <message>
        <source>Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds</source>
        <translation>将关键姿势（菱形）或条拖到别的时间；Shift、Ctrl 或框选可选多个。右键可缓动、保持、复制、镜像。线的两端表示图钉何时固定</translation>
    </message>
    <message>
        <source>Easing Curve</source>
        <translation>缓动曲线</translation>
    </message>
    <message>
        <source>Easing C&amp;urve…</source>
        <translation>缓动曲线(&amp;U)…</translation>
    </message>
</context>
<context>
    <name>wend::Tutorial</name>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Ends the tutorial; the picture stays open</source>
        <translation>结束教程；图片保持打开</translation>
    </message>
    <message>
        <source>Only what is pinned holds. &lt;b&gt;Click a hoof&lt;/b&gt; of the giraffe to pin it.</source>
        <translation>只有钉住的地方才固定不动。&lt;b&gt;单击长颈鹿的一只蹄子&lt;/b&gt;，将它钉住。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pin the other hooves&lt;/b&gt;, too, with a click each. Ctrl+Z undoes a pin.</source>
        <translation>&lt;b&gt;把其他蹄子也钉住&lt;/b&gt;，各单击一次。Ctrl+Z 撤销一个图钉。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click its nose&lt;/b&gt;, and &lt;b&gt;drag the new pin&lt;/b&gt; down to the ground. The shape flows along.</source>
        <translation>&lt;b&gt;单击它的鼻子&lt;/b&gt;，再把&lt;b&gt;新图钉拖动&lt;/b&gt;到地面。形状会流畅地跟随。</translation>
    </message>
    <message>
        <source>What it keeps on the way is your choice: at the top right, under &lt;b&gt;Keep&lt;/b&gt;, &lt;b&gt;choose Area, Rigid or Angle&lt;/b&gt;, and see the neck change.</source>
        <translation>变形时保持什么由您决定：在右上方的&lt;b&gt;“保持”&lt;/b&gt;下&lt;b&gt;选择“面积”“刚性”或“角度”&lt;/b&gt;，看看脖子如何变化。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press D&lt;/b&gt; to see in colours what the bend has changed, and where most. D again hides it.</source>
        <translation>&lt;b&gt;按 D&lt;/b&gt; 以颜色查看变形改变了什么、哪里改变最大。再按一次 D 隐藏。</translation>
    </message>
    <message>
        <source>The same for a part only: &lt;b&gt;press Ctrl+3&lt;/b&gt; for the step &lt;i&gt;Paint&lt;/i&gt;, and &lt;b&gt;brush over the neck&lt;/b&gt;. [ and ] change the size of the brush.</source>
        <translation>也可以只改局部：&lt;b&gt;按 Ctrl+3&lt;/b&gt; 进入&lt;i&gt;“绘制”&lt;/i&gt;步骤，&lt;b&gt;用画笔刷过脖子&lt;/b&gt;。[ 和 ] 更改画笔大小。</translation>
    </message>
    <message>
        <source>Your drag is already a film: &lt;b&gt;press K&lt;/b&gt; to play it. Click into the strip below to go to a time, and drag on from there.</source>
        <translation>您的拖动已经成为一段影片：&lt;b&gt;按 K&lt;/b&gt; 播放。单击下方的时间条可跳到某一时间，并从那里继续拖动。</translation>
    </message>
    <message>
        <source>That is all you need to begin. &lt;b&gt;F1&lt;/b&gt; opens the manual, &lt;b&gt;?&lt;/b&gt; lists the keys. Drop a picture of your own on the window.</source>
        <translation>入门所需就是这些。&lt;b&gt;F1&lt;/b&gt; 打开手册，&lt;b&gt;?&lt;/b&gt; 列出按键。将您自己的图片拖放到窗口中吧。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>Finally, &lt;b&gt;press Ctrl+5&lt;/b&gt; for the step &lt;i&gt;Export&lt;/i&gt;: a picture, a sequence, an ST map, or the mesh.</source>
        <translation>最后，&lt;b&gt;按 Ctrl+5&lt;/b&gt; 进入&lt;i&gt;“导出”&lt;/i&gt;步骤：图片、序列、ST 贴图或网格。</translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation>实体视图</translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation>无法绘制实体：%1</translation>
    </message>
</context>
<context>
    <name>wend::WorkNote</name>
    <message>
        <source>Cancel (Esc)</source>
        <translation>取消 (Esc)</translation>
    </message>
    <message>
        <source>Stops what is being computed and goes back to the last complete state</source>
        <translation>停止正在进行的计算，并回到上一个完整状态</translation>
    </message>
    <message>
        <source>Computing the motion: %1 %</source>
        <translation>正在计算运动：%1%</translation>
    </message>
    <message>
        <source>Meshing %1 …</source>
        <translation>正在为 %1 划分网格…</translation>
    </message>
    <message numerus="yes">
        <source>Meshing %1 with about %Ln vertices …</source>
        <translation>
            <numerusform>正在以约 %Ln 个顶点为 %1 划分网格…</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Filling the ground behind “%1” …</source>
        <translation>正在填充“%1”后面的背景…</translation>
    </message>
</context>
</TS>
