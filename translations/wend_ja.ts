<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP">
<context>
    <name>CheatSheet</name>
    <message>
        <source>Pointer</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>クリック</translation>
    </message>
    <message>
        <source>sets a pin</source>
        <translation>ピンを打つ</translation>
    </message>
    <message>
        <source>Drag a pin</source>
        <translation>ピンをドラッグ</translation>
    </message>
    <message>
        <source>moves it; Esc puts it back</source>
        <translation>移動（Esc で元に戻す）</translation>
    </message>
    <message>
        <source>Shift-click</source>
        <translation>Shift + クリック</translation>
    </message>
    <message>
        <source>selects several pins</source>
        <translation>複数のピンを選択</translation>
    </message>
    <message>
        <source>Digits while dragging</source>
        <translation>ドラッグ中に数字</translation>
    </message>
    <message>
        <source>set the number; Enter confirms it</source>
        <translation>数値を入力、Enter で確定</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>zooms to the pointer</source>
        <translation>ポインターの位置でズーム</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ と ]</translation>
    </message>
    <message>
        <source>size of a brush</source>
        <translation>ブラシのサイズ</translation>
    </message>
    <message>
        <source>Hold H</source>
        <translation>H を押している間</translation>
    </message>
    <message>
        <source>Hold \</source>
        <translation>\ を押している間</translation>
    </message>
    <message>
        <source>shows the shape before it was bent</source>
        <translation>変形前の形状を表示</translation>
    </message>
    <message>
        <source>X, Y, Z while dragging</source>
        <translation>ドラッグ中に X、Y、Z</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>軸を固定</translation>
    </message>
    <message>
        <source>Right or middle button</source>
        <translation>右ボタンまたは中ボタン</translation>
    </message>
    <message>
        <source>turns the view; with Shift, moves it</source>
        <translation>視点を回転、Shift で移動</translation>
    </message>
    <message>
        <source>Middle click</source>
        <translation>中クリック</translation>
    </message>
    <message>
        <source>sets the point to turn around</source>
        <translation>回転の中心を指定</translation>
    </message>
    <message>
        <source>widens it to a circle</source>
        <translation>円に広げる</translation>
    </message>
    <message>
        <source>Drag the ring&apos;s dot or square</source>
        <translation>リングの点または四角をドラッグ</translation>
    </message>
    <message>
        <source>rotates or scales; Shift snaps to 15°</source>
        <translation>回転または拡大・縮小、Shift で 15° 刻み</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>矢印キー</translation>
    </message>
    <message>
        <source>nudge by a pixel, with Shift by ten</source>
        <translation>1 ピクセル移動、Shift で 10 ピクセル</translation>
    </message>
    <message>
        <source>pans</source>
        <translation>画面を移動</translation>
    </message>
    <message>
        <source>Shift-click with the brush</source>
        <translation>ブラシで Shift+クリック</translation>
    </message>
    <message>
        <source>paints a straight line</source>
        <translation>直線を描きます</translation>
    </message>
    <message>
        <source>Arrow keys without a pin</source>
        <translation>ピンなしで矢印キー</translation>
    </message>
    <message>
        <source>move a cross, Enter clicks there</source>
        <translation>十字を動かし、Enter でそこをクリック</translation>
    </message>
    <message>
        <source>Alt-right-drag a brush</source>
        <translation>ブラシで Alt+右ドラッグ</translation>
    </message>
    <message>
        <source>changes its size and hardness</source>
        <translation>サイズと硬さを変更</translation>
    </message>
    <message>
        <source>Tap the space bar</source>
        <translation>スペースキーを軽く押す</translation>
    </message>
    <message>
        <source>plays or pauses; held, it moves the view</source>
        <translation>再生 / 一時停止（押したままでビューを移動）</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>中ボタン</translation>
    </message>
    <message>
        <source>hides pins and overlays</source>
        <translation>ピンとオーバーレイを隠す</translation>
    </message>
    <message>
        <source>Ctrl+Shift-drag a pin</source>
        <translation>Ctrl+Shift + ピンをドラッグ</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>上、下</translation>
    </message>
    <message>
        <source>choose a pin</source>
        <translation>ピンを選ぶ</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>左、右</translation>
    </message>
    <message>
        <source>show another time</source>
        <translation>別の時刻を表示</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt + 左、Alt + 右</translation>
    </message>
    <message>
        <source>move the chosen bars or keys</source>
        <translation>選択中のバーまたはキーを動かす</translation>
    </message>
    <message>
        <source>Shift-click, or a frame</source>
        <translation>Shift + クリック、または枠</translation>
    </message>
    <message>
        <source>chooses several</source>
        <translation>複数を選択</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>opens their easing curve</source>
        <translation>そのイージング曲線を開く</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl + C、Ctrl + V</translation>
    </message>
    <message>
        <source>copy keys, paste them at the time shown</source>
        <translation>キーをコピーし、表示中の時刻に貼り付ける</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl + Shift + V</translation>
    </message>
    <message>
        <source>pastes them mirrored</source>
        <translation>ミラーして貼り付ける</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>削除する</translation>
    </message>
    <message>
        <source>I, O</source>
        <translation>I、O</translation>
    </message>
    <message>
        <source>begin and end the cycle here</source>
        <translation>ここでサイクルを開始、終了</translation>
    </message>
    <message>
        <source>Shift-drag the numbers</source>
        <translation>Shift を押して数字をドラッグ</translation>
    </message>
    <message>
        <source>marks the cycle</source>
        <translation>サイクルを指定</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift + M</translation>
    </message>
    <message>
        <source>adds a marker</source>
        <translation>マーカーを追加</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>at time %1 %2 cannot go on: %3</source>
        <translation>時刻 %1 で %2 は進めません: %3</translation>
    </message>
    <message>
        <source>at time %1 the shape is too stiff to settle further near %2: the steps would be too short; allow a larger tolerance</source>
        <translation>時刻 %1 で形は %2 の近くで硬すぎて、それ以上落ち着けません。ステップが短くなりすぎます。許容誤差を大きくしてください</translation>
    </message>
    <message>
        <source>the shape would fold over near %1, in cell %2; move it less far or along another path, or release what holds the shape there</source>
        <translation>形が %1 の近く、セル %2 で折り返してしまいます。動きを小さくするか別の動かし方にするか、そこで形を押さえているものを外してください</translation>
    </message>
    <message>
        <source>the shape would fold over near %1; move it less far or along another path, or release what holds the shape there</source>
        <translation>形が %1 の近くで折り返してしまいます。動きを小さくするか別の動かし方にするか、そこで形を押さえているものを外してください</translation>
    </message>
    <message>
        <source>it moves too fast near %1: the steps would be too short; give its motion more time, or allow a larger tolerance</source>
        <translation>%1 の近くで速すぎて、ステップが短くなりすぎます。動きに時間をかけるか、許容誤差を大きくしてください</translation>
    </message>
    <message>
        <source>the shape near %1 is stretched or squeezed so much that no velocity can be computed; move it less far, or make the material or the mesh more even there</source>
        <translation>%1 の近くで形が伸びすぎ、または縮みすぎて、速度を計算できません。動きを小さくするか、そこの材質やメッシュをより均一にしてください</translation>
    </message>
    <message>
        <source>it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time</source>
        <translation>%1 の近くで速すぎて、数値があふれます。動きを小さくするか、動きに時間をかけてください</translation>
    </message>
    <message>
        <source>the shape needs about %1 of memory; %2 are free; fewer vertices need less</source>
        <translation>この形にはメモリが約 %1 必要ですが、空きは %2 です。頂点を減らすと少なくて済みます</translation>
    </message>
    <message>
        <source>%1 and %2 move the point %3 in different ways at time %4</source>
        <translation>%1 と %2 が点 %3 を時刻 %4 に異なる向きへ動かしています</translation>
    </message>
    <message>
        <source>handle &quot;%1&quot;</source>
        <translation>ピン「%1」</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>ピン %1</translation>
    </message>
    <message>
        <source>the shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>its region holds no vertex</source>
        <translation>その領域には頂点がありません</translation>
    </message>
    <message>
        <source>vertex %1 belongs to no cell</source>
        <translation>頂点 %1 はどのセルにも属していません</translation>
    </message>
    <message>
        <source>the picture has no alpha channel to take an outline from</source>
        <translation>画像には輪郭のもとになるアルファチャンネルがありません</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>画像にピクセルがありません</translation>
    </message>
    <message>
        <source>no part of the picture is as large as %1 pixels</source>
        <translation>画像に %1 ピクセル以上の部分がありません</translation>
    </message>
    <message>
        <source>the picture is fully transparent</source>
        <translation>画像は完全に透明です</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha is nowhere above the threshold of %1 %</source>
        <translation>画像のアルファはどこでもしきい値 %1 % を超えません</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha has too many contours: it looks like noise</source>
        <translation>画像のアルファの輪郭が多すぎます。ノイズのようです</translation>
    </message>
    <message>
        <source>the outline is empty</source>
        <translation>輪郭が空です</translation>
    </message>
    <message>
        <source>the outline crosses or overlaps itself near %1</source>
        <translation>輪郭が %1 の近くで交差または重なっています</translation>
    </message>
    <message>
        <source>the outline cannot be triangulated (%1)</source>
        <translation>輪郭を三角形分割できません (%1)</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same, %3</source>
        <translation>点 %1 と %2 は同じです、%3</translation>
    </message>
    <message>
        <source>point %1, %2, is outside the shape</source>
        <translation>点 %1、%2 は形の外です</translation>
    </message>
    <message>
        <source>an edge length of %1 would take more than %2 vertices</source>
        <translation>辺の長さ %1 には %2 個を超える頂点が必要です</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>は空です</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>は存在しません</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>はフォルダーです</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>はパイプであり、ファイルではありません</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>はデバイスであり、ファイルではありません</translation>
    </message>
    <message>
        <source>is a symbolic link that leads back to itself</source>
        <translation>は自分自身に戻るシンボリックリンクです</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>を読み込めません: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>に書き込めません: %1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>ディスクがいっぱいかもしれません</translation>
    </message>
    <message>
        <source>the disk is full, only %1 are free</source>
        <translation>ディスクがいっぱいです（空きは %1 だけです）</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>フォルダー %1 は存在しません</translation>
    </message>
    <message>
        <source>the folder %1 is not writable</source>
        <translation>フォルダー %1 に書き込めません</translation>
    </message>
    <message>
        <source>is read-only: make it writable first, or choose another name</source>
        <translation>は読み取り専用です。先に書き込み可能にするか、別の名前を選んでください</translation>
    </message>
    <message>
        <source>is a model or a mesh of a kind that is not read (%1); these are: %2</source>
        <translation>は読み込めない種類のモデルまたはメッシュです（%1）。読み込めるもの：%2</translation>
    </message>
    <message>
        <source>a JPEG XL picture</source>
        <translation>JPEG XL 画像</translation>
    </message>
    <message>
        <source>a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)</source>
        <translation>GIMP 画像 (XCF。GIMP から PNG または OpenRaster で書き出してください)</translation>
    </message>
    <message>
        <source>has a layer &quot;%1&quot; with an opacity out of range: it is limited to 0 … 100 %</source>
        <translation>レイヤー「%1」の不透明度が範囲外です: 0 … 100 % に制限されます</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文書</translation>
    </message>
    <message>
        <source>a film</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ZIP アーカイブ</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>テキストファイル</translation>
    </message>
    <message>
        <source>not a picture that Wend knows</source>
        <translation>Wend の知らない画像</translation>
    </message>
    <message>
        <source>cannot be read as a picture: %1</source>
        <translation>を画像として読み込めません: %1</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>にピクセルがありません</translation>
    </message>
    <message>
        <source>is a volume, not a picture</source>
        <translation>はボリュームであり、画像ではありません</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than %3 million</source>
        <translation>は %1 × %2 ピクセルで、%3 百万を超えています</translation>
    </message>
    <message>
        <source>is truncated or corrupt</source>
        <translation>は途中で切れているか壊れています</translation>
    </message>
    <message>
        <source>is transparent everywhere</source>
        <translation>はすべて透明です</translation>
    </message>
    <message>
        <source>holds tetrahedra, but the project is in the plane</source>
        <translation>は四面体を含みますが、プロジェクトは平面です</translation>
    </message>
    <message>
        <source>holds no tetrahedra, but the project is in space</source>
        <translation>は四面体を含みませんが、プロジェクトは空間です</translation>
    </message>
    <message>
        <source>the surface has no triangle</source>
        <translation>表面に三角形がありません</translation>
    </message>
    <message>
        <source>the surface has no extent</source>
        <translation>表面に広がりがありません</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>表面は体積を囲んでいません</translation>
    </message>
    <message>
        <source>the surface bounds no volume: %1</source>
        <translation>表面は体積を囲んでいません: %1</translation>
    </message>
    <message>
        <source>the surface intersects itself</source>
        <translation>表面が自分自身と交差しています</translation>
    </message>
    <message>
        <source>the surface has features too small for its size</source>
        <translation>表面の大きさに対して細部が小さすぎます</translation>
    </message>
    <message>
        <source>two facets of the surface lie almost on each other</source>
        <translation>表面の二つの面がほとんど重なっています</translation>
    </message>
    <message>
        <source>the volume mesher ran out of memory</source>
        <translation>体積メッシュの作成中にメモリーが足りなくなりました</translation>
    </message>
    <message>
        <source>the volume mesher did not finish within %1 s of computing; a coarser quality or a larger maxVolume may help</source>
        <translation>体積メッシュは %1 秒の計算で終わりませんでした。品質を下げるか、四面体を大きくすると良いかもしれません</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>すべての点が一つの平面上にあります</translation>
    </message>
    <message>
        <source>%1 open edge (first: %2)</source>
        <translation>開いた辺 %1 本 (%2)</translation>
    </message>
    <message>
        <source>%1 open edges (first: %2)</source>
        <translation>開いた辺 %1 本 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 edge of more than two triangles (first: %2)</source>
        <translation>三つ以上の三角形が共有する辺 %1 本 (%2)</translation>
    </message>
    <message>
        <source>%1 edges of more than two triangles (first: %2)</source>
        <translation>三つ以上の三角形が共有する辺 %1 本 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 pair of triangles that intersect (first: %2)</source>
        <translation>交差する三角形の組 %1 組 (%2)</translation>
    </message>
    <message>
        <source>%1 pairs of triangles that intersect (first: %2)</source>
        <translation>交差する三角形の組 %1 組 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 triangle without area (first: %2)</source>
        <translation>面積のない三角形 %1 個 (%2)</translation>
    </message>
    <message>
        <source>%1 triangles without area (first: %2)</source>
        <translation>面積のない三角形 %1 個 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangle (first: %2)</source>
        <translation>重複した三角形 %1 個 (%2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangles (first: %2)</source>
        <translation>重複した三角形 %1 個 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 edge where the orientation changes (first: %2)</source>
        <translation>向きが変わる辺 %1 本 (%2)</translation>
    </message>
    <message>
        <source>%1 edges where the orientation changes (first: %2)</source>
        <translation>向きが変わる辺 %1 本 (最初: %2)</translation>
    </message>
    <message>
        <source>the surface was repaired: %1</source>
        <translation>表面を修復しました: %1</translation>
    </message>
    <message>
        <source>%1 coincident vertex merged</source>
        <translation>重なる頂点 %1 個を統合</translation>
    </message>
    <message>
        <source>%1 coincident vertices merged</source>
        <translation>重なる頂点 %1 個を統合</translation>
    </message>
    <message>
        <source>%1 triangle without area dropped</source>
        <translation>面積のない三角形 %1 個を削除</translation>
    </message>
    <message>
        <source>%1 triangles without area dropped</source>
        <translation>面積のない三角形 %1 個を削除</translation>
    </message>
    <message>
        <source>%1 duplicate triangle dropped</source>
        <translation>重複した三角形 %1 個を削除</translation>
    </message>
    <message>
        <source>%1 duplicate triangles dropped</source>
        <translation>重複した三角形 %1 個を削除</translation>
    </message>
    <message>
        <source>%1 triangle turned over</source>
        <translation>三角形 %1 個を裏返し</translation>
    </message>
    <message>
        <source>%1 triangles turned over</source>
        <translation>三角形 %1 個を裏返し</translation>
    </message>
    <message>
        <source>%1 hole filled</source>
        <translation>穴 %1 個を埋めました</translation>
    </message>
    <message>
        <source>%1 holes filled</source>
        <translation>穴 %1 個を埋めました</translation>
    </message>
    <message>
        <source>the surface is embedded in a cage of %1 vertices, since %2</source>
        <translation>表面は %1 頂点のケージに埋め込まれています。理由: %2</translation>
    </message>
    <message>
        <source>it cannot be meshed as it is: %1</source>
        <translation>そのままではメッシュにできません: %1</translation>
    </message>
    <message>
        <source>it has %1 vertices, where %2 were aimed at</source>
        <translation>目標 %2 に対して頂点が %1 個あります</translation>
    </message>
    <message>
        <source>the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer</source>
        <translation>目標 %2 に対してケージの頂点は %1 個です。立方体ではこれ以上近づけません</translation>
    </message>
    <message>
        <source>the cells of the cage are larger than asked for: there is no memory for smaller ones</source>
        <translation>ケージのセルは指定より大きくなっています。小さくするにはメモリーが足りません</translation>
    </message>
    <message>
        <source>sizes are for the exact surface: a cage has cells of one size</source>
        <translation>サイズ指定は正確な表面のためのものです。ケージのセルは同じ大きさです</translation>
    </message>
    <message>
        <source>its %1 parts share cells of the cage and move together as %2: smaller cells keep more of them apart</source>
        <translation>%1 個の部分がケージのセルを共有し、%2 個として一緒に動きます。セルを小さくするとより多く分かれます</translation>
    </message>
    <message>
        <source>the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow</source>
        <translation>ケージはつながっていない %1 個の塊です。それぞれに独自のピンが必要です</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie outside the solid that carries them</source>
        <translation>%2 頂点のうち %1 個が、それを運ぶ立体の外にあります</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them</source>
        <translation>目標 %2 に対してメッシュの頂点は %1 個です。指定の品質に必要です</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is</source>
        <translation>目標 %2 に対してメッシュの頂点は %1 個です。表面はそのまま保たれます</translation>
    </message>
    <message>
        <source>the surface&apos;s triangles are far larger than the cells inside and are kept as they are, which makes uneven cells</source>
        <translation>表面の三角形は内部のセルよりずっと大きく、そのまま保たれるため、セルが不均一になります</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell is above it)</source>
        <translation>最悪のセルの半径と辺の比は %1 で、指定は %2 です (%3 セルが超過)</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells are above it)</source>
        <translation>最悪のセルの半径と辺の比は %1 で、指定は %2 です (%3 セルが超過)</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2</source>
        <translation>%1: 表面がそのまま保たれ、その三角形 %2 が原因です</translation>
    </message>
    <message>
        <source>%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written without them, so that later vertices have other numbers</source>
        <translation>表面の %1 頂点はどの四面体にも属していません。四面体メッシュはそれらを除いて書き出され、以降の番号が変わります</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 頂点はどのセルにも属していません。書き出しには残ります。ソルバーによっては先に取り除く必要があります</translation>
    </message>
    <message>
        <source>parts that touch vertex to vertex are connected: %1 vertices move with others at the same place</source>
        <translation>頂点どうしで接する部分はつながります。%1 頂点が同じ場所の頂点と一緒に動きます</translation>
    </message>
    <message>
        <source>a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 からなる部分が %3 付近の %2 だけでつながっています。自由に回るため、ピンで押さえないと遠くへ飛ばされることがあります</translation>
    </message>
    <message>
        <source>%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 個の部分が一つの頂点または辺だけでつながっています。最初は %2 からなり、%4 付近の %3 です。自由に回るため、ピンで押さえないと遠くへ飛ばされることがあります</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 セル</translation>
    </message>
    <message>
        <source>%1 cell</source>
        <translation>%1 セル</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>頂点 %1</translation>
    </message>
    <message>
        <source>the edge %1</source>
        <translation>辺 %1</translation>
    </message>
    <message>
        <source>%1 single step</source>
        <translation>個別の手順 %1 件</translation>
    </message>
    <message>
        <source>%1 single steps</source>
        <translation>個別の手順 %1 件</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>三角形 %1 はありません</translation>
    </message>
    <message>
        <source>no hole has the edge %1</source>
        <translation>辺 %1 をもつ穴はありません</translation>
    </message>
    <message>
        <source>the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves together</source>
        <translation>ケージが一つの部品の中の隙間を閉じます（幅 %1、%2 付近）。両側は一緒に動きます</translation>
    </message>
    <message>
        <source>the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on both sides moves together</source>
        <translation>ケージが一つの部品の中の隙間を %1 か所閉じます（最も狭いのは幅 %2、%3 付近）。両側は一緒に動きます</translation>
    </message>
    <message>
        <source>%1; about %2 vertices open the widest</source>
        <translation>%1。約 %2 頂点で最も広い隙間が開きます</translation>
    </message>
    <message>
        <source>%1; cells of at most %2 open the widest</source>
        <translation>%1。大きさ %2 以下のセルで最も広い隙間が開きます</translation>
    </message>
    <message>
        <source>%1; a detail of %2 opens the widest</source>
        <translation>%1。細かさ %2 で最も広い隙間が開きます</translation>
    </message>
    <message>
        <source>1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, so that later vertices have other numbers</source>
        <translation>表面の 1 頂点がどの四面体にも属しません。四面体メッシュはそれなしで書かれ、以降の番号が変わります</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 頂点がどのセルにも属しません。書き出しには残ります。先に除く必要のあるソルバーもあります</translation>
    </message>
    <message>
        <source>holds %1 points, but neither triangles nor tetrahedra between them: a surface has to be made of the points first, as MeshLab and CloudCompare do</source>
        <translation>%1 個の点がありますが、それらをつなぐ三角形も四面体もありません。まず MeshLab や CloudCompare などで点から面を作ってください</translation>
    </message>
    <message>
        <source>%1: its points have four coordinates; only points in space, which have three, are read</source>
        <translation>%1: 点の座標が四つあります。読めるのは座標が三つの空間の点だけです</translation>
    </message>
    <message>
        <source>the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells may help</source>
        <translation>ケージは %1 秒の計算で終わりませんでした。頂点を減らすか、セルを大きくすると良いかもしれません</translation>
    </message>
    <message>
        <source>there is no memory for a cage of so many cells; fewer vertices or larger cells may help</source>
        <translation>これほど多くのセルのケージにはメモリーが足りません。頂点を減らすか、セルを大きくすると良いかもしれません</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and about %3 vertices open the widest</source>
        <translation>%1。細かさ %2 と約 %3 頂点で最も広い隙間が開きます</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and cells of at most %3 open the widest</source>
        <translation>%1。細かさ %2 と %3 以下のセルで最も広い隙間が開きます</translation>
    </message>
    <message>
        <source>a list of points without a surface</source>
        <translation>面のない点の一覧</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: its outline needs them</source>
        <translation>目標 %2 に対してメッシュの頂点は %1 個です。輪郭に必要です</translation>
    </message>
    <message>
        <source>is no project of Wend, which is JSON and begins with {</source>
        <translation>は Wend のプロジェクトではありません(JSON で、{ から始まります)</translation>
    </message>
    <message>
        <source>has %1 pictures (pages, frames or parts): the first one is read</source>
        <translation>%1 枚の画像（ページ、フレームまたはパート）を含みます。最初のものを読み込みます</translation>
    </message>
    <message>
        <source>has channels that are left out: %1</source>
        <translation>読み込まれないチャンネルがあります: %1</translation>
    </message>
    <message>
        <source>has a channel of no declared kind after its colours: it is taken as alpha</source>
        <translation>色の後に種類の宣言されていないチャンネルがあります。アルファとして扱います</translation>
    </message>
    <message>
        <source>reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off</source>
        <translation>%1 x %2 ピクセルの表示ウィンドウからはみ出しています。外側は切り取られます</translation>
    </message>
    <message>
        <source>has a colour profile that does not fit its colours: it is left out</source>
        <translation>色に合わないカラープロファイルがあります。使用しません</translation>
    </message>
    <message>
        <source>has a colour space that is not known (cICP %1): it is not kept</source>
        <translation>未知の色空間（cICP %1）です。保持されません</translation>
    </message>
    <message>
        <source>1 pixel is not a finite number (NaN or infinity), at x %1, y %2</source>
        <translation>1 個のピクセルが有限の数ではありません（NaN または無限大）。位置 x %1、y %2</translation>
    </message>
    <message>
        <source>%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3</source>
        <translation>%1 個のピクセルが有限の数ではありません（NaN または無限大）。最初の位置 x %2、y %3</translation>
    </message>
    <message>
        <source>is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures</source>
        <translation>は%1です。Wend は PNG、JPEG、TIFF、EXR、WebP、GIF、PSD、OpenRaster、Krita、SVG、HEIC、AVIF、JPEG 2000、カメラ RAW などの画像を開けます</translation>
    </message>
    <message>
        <source>its reader failed inside (signal %1)</source>
        <translation>読み込みプログラムが異常終了しました (シグナル %1)</translation>
    </message>
    <message>
        <source>its reader was ended (signal %1)</source>
        <translation>読み込みプログラムが終了させられました (シグナル %1)</translation>
    </message>
    <message>
        <source>its reader failed (exit code %1)</source>
        <translation>読み込みプログラムが失敗しました (終了コード %1)</translation>
    </message>
    <message>
        <source>its reader has done nothing for %1 s</source>
        <translation>読み込みプログラムが %1 秒間何もしていません</translation>
    </message>
    <message>
        <source>its reader has not come to an end</source>
        <translation>読み込みプログラムが終わりませんでした</translation>
    </message>
    <message>
        <source>it needs more than the %1 MB of memory that reading may take</source>
        <translation>読み込みに許される %1 MB を超えるメモリが必要です</translation>
    </message>
    <message>
        <source>has %1 layers: opened flattened</source>
        <translation>にはレイヤーが %1 枚あります: 統合して開きました</translation>
    </message>
    <message>
        <source>holds no picture of all its layers (%1): save it with one</source>
        <translation>には全レイヤーを統合した画像 (%1) がありません: 付けて保存し直してください</translation>
    </message>
    <message>
        <source>has a damaged %1</source>
        <translation>の中の %1 が壊れています</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and %3 times more</source>
        <translation>時刻 %1 に形が %2 付近で別の釣り合いへ飛び移り、さらに %3 回飛び移ります</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2</source>
        <translation>時刻 %1 に形が %2 付近で別の釣り合いへ飛び移ります</translation>
    </message>
    <message>
        <source>pins of the other project without a namesake here, placed in proportion: %1</source>
        <translation>同名のピンがないため比率に従って置いた、他のプロジェクトのピン: %1</translation>
    </message>
    <message>
        <source>pins of the other project that find no place here and are left out: %1</source>
        <translation>置く場所がないため省いた、他のプロジェクトのピン: %1</translation>
    </message>
    <message>
        <source>pins without a motion in the other project, which hold still: %1</source>
        <translation>他のプロジェクトに動きがなく、静止するピン: %1</translation>
    </message>
    <message>
        <source>moves a solid: its motion does not fit a picture</source>
        <translation>ソリッドを動かすもので、その動きは画像には合いません</translation>
    </message>
    <message>
        <source>moves a picture: its motion does not fit a solid</source>
        <translation>画像を動かすもので、その動きはソリッドには合いません</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3</source>
        <translation>殻が最大 %1 重に入れ子になっています。満たした空間: %2、空洞: %3</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces filled: %2, hollow: %3</source>
        <translation>殻が最大 %1 重に入れ子になり、物体どうしが壁を共有して接しています。満たした空間: %2、空洞: %3</translation>
    </message>
    <message>
        <source>bodies touch along shared walls; spaces filled: %1, hollow: %2</source>
        <translation>物体どうしが壁を共有して接しています。満たした空間: %1、空洞: %2</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled</source>
        <translation>%1 は %2 × %3 ピクセルで、プロジェクトは %4 × %5 用に作られています。ピンと軌道を拡大縮小しました</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where they are</source>
        <translation>%1 は %2 × %3 ピクセルで、プロジェクトは %4 × %5 用に作られています。ピンと軌道はそのままです</translation>
    </message>
    <message>
        <source>the project&apos;s picture is no SVG drawing: it has no paths that could be written</source>
        <translation>プロジェクトの画像は SVG の図ではないため、書き出せるパスがありません</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is no SVG drawing: it becomes a picture in the SVG file</source>
        <translation>パーツ「%1」は SVG の図ではないため、SVG ファイルでは画像になります</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is cut: it becomes a picture in the SVG file</source>
        <translation>パーツ「%1」は切り抜かれているため、SVG ファイルでは画像になります</translation>
    </message>
    <message>
        <source>its pattern &quot;%1&quot; turns and stretches with each shape, but is not bent</source>
        <translation>模様「%1」は図形とともに回転・伸縮しますが、曲がりません</translation>
    </message>
    <message>
        <source>a picture in it stays one</source>
        <translation>含まれる画像は画像のままです</translation>
    </message>
    <message>
        <source>its picture &quot;%1&quot; is not in the file: it is left out</source>
        <translation>画像「%1」はファイルに含まれていないため省かれます</translation>
    </message>
    <message>
        <source>its text along a path is left out</source>
        <translation>パスに沿った文字は省かれます</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; is left out</source>
        <translation>&lt;%1&gt; は省かれます</translation>
    </message>
    <message>
        <source>HDF5 files need wend-hdf5, which is missing beside the program: it is built where libhdf5-dev is installed</source>
        <translation>HDF5 ファイルには wend-hdf5 が必要ですが、プログラムと同じ場所にありません: libhdf5-dev がある環境でビルドされます</translation>
    </message>
    <message>
        <source>the HDF5 library fails on it: the file may be damaged</source>
        <translation>HDF5 ライブラリで処理できません: ファイルが壊れている可能性があります</translation>
    </message>
    <message>
        <source>is no HDF5 file</source>
        <translation>HDF5 ファイルではありません</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both the same triangles there or leave a gap</source>
        <translation>立体 %1 と %2 は三角形の一致しない面で接しています（%3 付近）: そこで両方に同じ三角形を与えるか、隙間を空けてください</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along an edge or at a point (near %3): give both the same triangles there or leave a gap</source>
        <translation>立体 %1 と %2 は辺または点で接しています（%3 付近）: そこで両方に同じ三角形を与えるか、隙間を空けてください</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell; it lies at the place of another and moves with it. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 頂点がどのセルにも属しません。別の頂点と同じ位置にあり、一緒に動きます。書き出しには残ります。先に除く必要のあるソルバーもあります</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell; %2 of them lie at the place of another and move with it. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 頂点はどのセルにも属していません。うち %2 頂点は別の頂点と同じ位置にあり、一緒に動きます。書き出しには残ります。ソルバーによっては先に取り除く必要があります</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more</source>
        <translation>%1: 表面がそのまま保たれ、その三角形 %2 と他 %3 個が原因です</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; has the blend mode %2: it is shown as normal</source>
        <translation>レイヤー「%1」の描画モードは %2 です。通常として表示します</translation>
    </message>
    <message>
        <source>1 hole of %1 edges stayed open, larger than the limit of %2</source>
        <translation>辺 %1 本の穴 1 個は、上限 %2 より大きいため開いたままです</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 edges stayed open, larger than the limit of %3</source>
        <translation>辺が最大 %2 本の穴 %1 個は、上限 %3 より大きいため開いたままです</translation>
    </message>
    <message>
        <source>1 vertex of open seams welded, the widest gap %1</source>
        <translation>開いた継ぎ目の頂点 1 個を接合 (最大の隙間 %1)</translation>
    </message>
    <message>
        <source>%1 vertices of open seams welded, the widest gap %2</source>
        <translation>開いた継ぎ目の頂点 %1 個を接合 (最大の隙間 %2)</translation>
    </message>
    <message>
        <source> (after the repair: %1)</source>
        <translation> (修復後: %1)</translation>
    </message>
    <message>
        <source>; the repair found nothing that it could repair</source>
        <translation>。修復できる箇所は見つかりませんでした</translation>
    </message>
    <message>
        <source>%1 and %2 move the joint at %3 in different ways at time %4</source>
        <translation>%1 と %2 が %3 の関節を時刻 %4 に異なる向きへ動かしています</translation>
    </message>
    <message>
        <source>the multigrid solver did not find the velocities near %1; solve directly (--solver direct), or make the material or the mesh more even</source>
        <translation>マルチグリッドソルバーは %1 の近くの速度を求められませんでした。直接法 (--solver direct) を使うか、材質やメッシュをより均一にしてください</translation>
    </message>
    <message>
        <source>%1: its points have any number of coordinates; only points in space, which have three, are read</source>
        <translation>%1: 点の座標の数が決まっていません。読めるのは座標が三つの空間の点だけです</translation>
    </message>
    <message>
        <source>%1 vertex that is not finite (first: %2)</source>
        <translation>有限でない頂点 %1 個 (%2)</translation>
    </message>
    <message>
        <source>%1 vertices that are not finite (first: %2)</source>
        <translation>有限でない頂点 %1 個 (最初: %2)</translation>
    </message>
    <message>
        <source>%1 triangle that names a missing vertex (first: %2)</source>
        <translation>存在しない頂点を指す三角形 %1 個 (%2)</translation>
    </message>
    <message>
        <source>%1 triangles that name a missing vertex (first: %2)</source>
        <translation>存在しない頂点を指す三角形 %1 個 (最初: %2)</translation>
    </message>
    <message>
        <source>an IFF file</source>
        <translation>IFF ファイル</translation>
    </message>
    <message>
        <source>a KTX texture</source>
        <translation>KTX テクスチャ</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>PostScript 文書</translation>
    </message>
    <message>
        <source>a PAM picture</source>
        <translation>PAM 画像</translation>
    </message>
    <message>
        <source>a Windows cursor</source>
        <translation>Windows のカーソル</translation>
    </message>
    <message>
        <source>a QOI picture</source>
        <translation>QOI 画像</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 2 GB, these layers have more</source>
        <translation>に書き込めません: Photoshop ファイルは最大 2 GB ですが、これらのレイヤーはそれより大きくなります</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 30000 pixels a side</source>
        <translation>に書き込めません: Photoshop ファイルの一辺は最大 30000 ピクセルです</translation>
    </message>
    <message>
        <source>the shape is too stiff to settle further near %1: the steps would be too short; allow a larger tolerance</source>
        <translation>形は %1 の近くで硬すぎて、それ以上落ち着けません。ステップが短くなりすぎます。許容誤差を大きくしてください</translation>
    </message>
    <message>
        <source>%1 cannot go on: %2</source>
        <translation>%1 は進めません: %2</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and once more</source>
        <translation>時刻 %1 に形が %2 付近で別の釣り合いへ飛び移り、さらにもう 1 回飛び移ります</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2</source>
        <translation>%1 秒で形が %2 付近から別のポーズへ飛び移ります</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and once more</source>
        <translation>%1 秒で形が %2 付近から別のポーズへ飛び移り、さらにもう 1 回飛び移ります</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and %3 times more</source>
        <translation>%1 秒で形が %2 付近から別のポーズへ飛び移り、さらに %3 回飛び移ります</translation>
    </message>
</context>
<context>
    <name>CropTool</name>
    <message>
        <source>Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the proportions, Delete or a double-click removes it</source>
        <translation>書き出しに残す範囲を四角で囲みます。内側や辺をドラッグして変更、Shift で縦横比を維持、Delete またはダブルクリックで解除</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Double-click to insert a point into the curve</source>
        <translation>曲線をダブルクリックするとポイントを挿入します</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>曲線を変更</translation>
    </message>
    <message>
        <source>Insert curve point</source>
        <translation>曲線にポイントを挿入</translation>
    </message>
    <message>
        <source>Delete curve point</source>
        <translation>曲線のポイントを削除</translation>
    </message>
    <message>
        <source>The ends of a curve must stay.</source>
        <translation>曲線の両端は削除できません。</translation>
    </message>
    <message>
        <source>Drag the curve&apos;s point, Shift keeps it straight, Ctrl moves one direction only; Delete removes it, a right-click shows more</source>
        <translation>曲線のポイントをドラッグ、Shift でまっすぐ、Ctrl で片側の方向だけ。Delete で削除、右クリックでその他の操作</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Drag the arrow to move the cut, the rings to tilt it; Esc puts it back</source>
        <translation>矢印で断面を移動、リングで傾けます。Esc で元に戻します</translation>
    </message>
</context>
<context>
    <name>DepthTool</name>
    <message>
        <source>Brush over what lies in front or behind; Ctrl clears it, Shift swaps front and back, [ and ] change the size</source>
        <translation>手前または奥にくる部分をブラシでなぞります。Ctrl で消去、Shift で前後を反転、[ と ] でサイズを変更</translation>
    </message>
    <message>
        <source>Paint in front</source>
        <translation>手前にペイント</translation>
    </message>
    <message>
        <source>Paint behind</source>
        <translation>奥にペイント</translation>
    </message>
    <message>
        <source>Clear depth</source>
        <translation>奥行きを消去</translation>
    </message>
</context>
<context>
    <name>EaseNames</name>
    <message>
        <source>Ease &amp;In</source>
        <translation>イーズイン(&amp;I)</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>イーズアウト(&amp;O)</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>イーズイン／アウト(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>リニア(&amp;L)</translation>
    </message>
</context>
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Nothing grows or shrinks. Parts may get thin.</source>
        <translation>拡大も縮小もしません。細くなる部分が出ることがあります。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Stretches least. Start here.</source>
        <translation>伸びが最小です。まずはこれから。</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>剛体</translation>
    </message>
    <message>
        <source>Parts turn like card.</source>
        <translation>各部が厚紙のように回ります。</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Details keep their look. Parts may swell.</source>
        <translation>細部の見た目を保ちます。膨らむ部分が出ることがあります。</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
</context>
<context>
    <name>ExportFormats</name>
    <message>
        <source>Layers (OpenRaster)</source>
        <translation>レイヤー (OpenRaster)</translation>
    </message>
    <message>
        <source>This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). Animated WebP needs no other program.</source>
        <translation>このフィルムはプログラム ffmpeg で作られますが、インストールされていません（Debian：sudo apt install ffmpeg）。アニメーション WebP には他のプログラムは要りません。</translation>
    </message>
    <message>
        <source>glTF film</source>
        <translation>glTFフィルム</translation>
    </message>
    <message>
        <source>Spine skeleton</source>
        <translation>Spineスケルトン</translation>
    </message>
    <message>
        <source>DragonBones skeleton</source>
        <translation>DragonBonesスケルトン</translation>
    </message>
    <message>
        <source>Layers (Photoshop)</source>
        <translation>レイヤー (Photoshop)</translation>
    </message>
</context>
<context>
    <name>FileCard</name>
    <message>
        <source>Eyes stay round</source>
        <translation>目は丸いまま</translation>
    </message>
    <message>
        <source>Pins and paths</source>
        <translation>ピンとパス</translation>
    </message>
    <message>
        <source>Many pins at once</source>
        <translation>多数のピンを同時に</translation>
    </message>
    <message>
        <source>Flight, with a skin</source>
        <translation>スキン付きの翼</translation>
    </message>
    <message>
        <source>A stiff middle</source>
        <translation>中央だけ硬く</translation>
    </message>
    <message>
        <source>Frog</source>
        <translation>カエル</translation>
    </message>
    <message>
        <source>Giraffe</source>
        <translation>キリン</translation>
    </message>
    <message>
        <source>Octopus</source>
        <translation>タコ</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>帯</translation>
    </message>
    <message>
        <source>Eagle</source>
        <translation>ワシ</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>棒</translation>
    </message>
    <message>
        <source>Choose what to keep</source>
        <translation>保持するものを選ぶ</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>歩く人</translation>
    </message>
    <message>
        <source>A walk that loops</source>
        <translation>ループする歩行</translation>
    </message>
</context>
<context>
    <name>FillTool</name>
    <message>
        <source>Click to pick up what is painted there</source>
        <translation>クリックした場所のペイントを取得します</translation>
    </message>
    <message>
        <source>Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up</source>
        <translation>クリックでつながった部分を塗りつぶします。Shift で全体、Ctrl でペイントを消去、Alt で取得</translation>
    </message>
    <message>
        <source>Fill with %1</source>
        <translation>「%1」で塗りつぶし</translation>
    </message>
</context>
<context>
    <name>GrabTool</name>
    <message>
        <source>Draw around the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>つかむパーツを囲んで描きます。Shift で選択中のパーツに追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>つかむパーツをブラシでなぞります。[ と ] でサイズを変更、Shift で追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>つかむパーツを長方形で囲みます。Shift で選択中のパーツに追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>No part of the shape lies in this outline.</source>
        <translation>この輪郭の中に形状はありません。</translation>
    </message>
    <message>
        <source>Select one part to take away from.</source>
        <translation>除外元のパーツを 1 つ選択してください。</translation>
    </message>
    <message>
        <source>A handle must hold something; Delete removes it.</source>
        <translation>ハンドルを空にはできません。削除するには Delete キーを押してください。</translation>
    </message>
</context>
<context>
    <name>GradientTool</name>
    <message>
        <source>Move gradient</source>
        <translation>グラデーションを移動</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>「%1」へ</translation>
    </message>
    <message>
        <source>Blend to %1</source>
        <translation>「%1」へ変化</translation>
    </message>
    <message>
        <source>Drag over the shape to blend evenly from what is there to what is chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels</source>
        <translation>形状の上をドラッグすると、今の状態から右側で選んだものへ均一に変化します。Shift で 45° 刻み、Alt で取得、Esc で中止</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Stretch</source>
        <translation>伸び</translation>
    </message>
    <message>
        <source>stretch %1</source>
        <translation>伸び %1</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>area ×%1</source>
        <translation>面積 ×%1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>volume ×%1</source>
        <translation>体積 ×%1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>angle error %1</source>
        <translation>角度誤差 %1</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>セルサイズ</translation>
    </message>
    <message>
        <source>Distance from rest</source>
        <translation>変形前からの距離</translation>
    </message>
    <message>
        <source>Influence of the pin</source>
        <translation>ピンの影響</translation>
    </message>
    <message>
        <source>Stretched too far here · %1</source>
        <translation>ここは伸ばしすぎ · %1</translation>
    </message>
    <message>
        <source>Grown too far here · %1</source>
        <translation>ここは広がりすぎ · %1</translation>
    </message>
    <message>
        <source>Shrunk too far here · %1</source>
        <translation>ここは縮みすぎ · %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>スケール済みヤコビアン</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>アスペクト比</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>最小の角度</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>最小の二面角</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears</source>
        <translation>2 点をクリックで長さ、3 点目で角度を測ります。Ctrl で頂点に吸着、Esc でクリア</translation>
    </message>
    <message>
        <source>angle %1, at rest %2</source>
        <translation>角度 %1（変形前 %2）</translation>
    </message>
    <message>
        <source>length %1, at rest %2</source>
        <translation>長さ %1（変形前 %2）</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>領域</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>Det&amp;ail, in vertices</source>
        <translation>細かさ（頂点数）(&amp;A)</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>頂点数</translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation>メッシュの細かさです。頂点が多いほど滑らかに変形しますが、時間がかかります。</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>細かさを変更</translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation>輪郭(&amp;O)</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>輪郭を変更</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>画像全体</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>切り抜き</translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation>描いた多角形</translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation>これより不透明なピクセルが形状に含まれます。</translation>
    </message>
    <message>
        <source>Change what counts as solid</source>
        <translation>不透明とみなす下限を変更</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>余白(&amp;R)</translation>
    </message>
    <message>
        <source>The outline grows by this much, so that soft edges are kept whole.</source>
        <translation>ぼけた縁まで含めて変形するように、輪郭をこの幅だけ広げます。</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>余白を変更</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>画像の端(&amp;B)</translation>
    </message>
    <message>
        <source>Picture&apos;s border</source>
        <translation>画像の端</translation>
    </message>
    <message>
        <source>Holds the frame of a photograph, so that no gap opens at its edge: it stays where it is, or its sides slide along themselves. Pins on it still move.</source>
        <translation>写真の枠を固定し、周囲に隙間ができないようにします。枠はその場に留まるか、各辺が辺に沿って滑ります。枠の上のピンはそれでも動きます。</translation>
    </message>
    <message>
        <source>Hold the border</source>
        <translation>画像の端を固定</translation>
    </message>
    <message>
        <source>Moves freely</source>
        <translation>自由に動く</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>その場に留める</translation>
    </message>
    <message>
        <source>Slides along itself</source>
        <translation>辺に沿って滑る</translation>
    </message>
    <message>
        <source>Radius–edge rati&amp;o</source>
        <translation>半径・辺長比(&amp;O)</translation>
    </message>
    <message>
        <source>How flat the tetrahedra may be: the maximum ratio of circumradius to shortest edge. Smaller is rounder and takes more of them.</source>
        <translation>四面体の扁平さの上限：外接球半径と最短辺の比の最大値。小さいほど丸く、四面体の数が増えます。</translation>
    </message>
    <message>
        <source>Change radius–edge ratio</source>
        <translation>半径・辺長比を変更</translation>
    </message>
    <message>
        <source>Ma&amp;ximum volume</source>
        <translation>最大体積(&amp;G)</translation>
    </message>
    <message>
        <source>Larger tetrahedra are split; in the file&apos;s units, cubed. Half the volume makes about twice as many. At a surface that is kept, some may stay larger.</source>
        <translation>これより大きい四面体は分割されます（単位はファイルの単位の 3 乗）。半分にすると数はおよそ 2 倍になります。サーフェスを保つ場合、その付近に大きいものが残ることがあります。</translation>
    </message>
    <message>
        <source>Change maximum volume</source>
        <translation>最大体積を変更</translation>
    </message>
    <message>
        <source>Refine s&amp;urface</source>
        <translation>サーフェスを細分化(&amp;U)</translation>
    </message>
    <message>
        <source>Allows the surface&apos;s triangles to be split where they are larger than the tetrahedra inside. If off, the surface is kept exactly as it is.</source>
        <translation>内部の四面体より大きいサーフェスの三角形を分割します。オフの場合、サーフェスはそのまま保たれます。</translation>
    </message>
    <message>
        <source>Refine surface</source>
        <translation>サーフェスを細分化</translation>
    </message>
    <message>
        <source>Fill holes up to (edges)</source>
        <translation>穴埋めの上限（辺数）</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>最大の穴</translation>
    </message>
    <message>
        <source>“Repair” fills holes of at most this many edges.</source>
        <translation>「修復」は、辺の数がこの値以下の穴を埋めます。</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>充填方法(&amp;I)</translation>
    </message>
    <message>
        <source>What is filled: the surface itself, or a cage of even cells around it, in which it is embedded. Automatic takes the cage where the surface cannot be filled or has far too many vertices.</source>
        <translation>何を充填するか：サーフェスそのもの、またはそれを包む均一なセルのケージ（サーフェスはそれに追従します）。「自動」では、サーフェスを充填できない場合や頂点が多すぎる場合にケージを使います。</translation>
    </message>
    <message>
        <source>Change fit</source>
        <translation>充填方法を変更</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Exact surface</source>
        <translation>正確なサーフェス</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>ケージ</translation>
    </message>
    <message>
        <source>Exact &amp;balance</source>
        <translation>バランス値(&amp;B)</translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation>エネルギーを変更</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
    <message>
        <source>Smoothi&amp;ng length</source>
        <translation>平滑化の長さ(&amp;N)</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads, as a fraction of the shape&apos;s size. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation>ピンの引く力が広がる範囲を、形状の大きさに対する割合で表します。小さいとピンの近くだけ鋭く、大きいと柔らかく広く変形します。</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>平滑化を変更</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>number of frames, evenly spaced from the start to the last time</source>
        <translation>開始から最後の時刻までを等間隔に分けたフレーム数</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>フレーム数(&amp;R)</translation>
    </message>
    <message>
        <source>whether distortion, φ, directions and velocity are written with meshes, in formats that carry values</source>
        <translation>値を持てる形式のメッシュに、ひずみ、φ、方向、速度を含めるかどうか</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>値(&amp;V)</translation>
    </message>
    <message>
        <source>Errors, material, velocity</source>
        <translation>誤差、材質、速度</translation>
    </message>
    <message>
        <source>The shape alone</source>
        <translation>形状のみ</translation>
    </message>
    <message>
        <source>how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)</source>
        <translation>複数の書き方があるメッシュ形式（ply、stl、msh、vtk、vtu）での数値の形式</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>数値の形式(&amp;N)</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>バイナリ</translation>
    </message>
    <message>
        <source>Binary, compressed</source>
        <translation>バイナリ（圧縮）</translation>
    </message>
    <message>
        <source>version of .msh files</source>
        <translation>.msh ファイルのバージョン</translation>
    </message>
    <message>
        <source>&amp;Gmsh version</source>
        <translation>Gmsh バージョン(&amp;G)</translation>
    </message>
    <message>
        <source>write the triangles of a solid&apos;s border as cells too, with the values of the tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless the input had such triangles</source>
        <translation>ソリッドの境界の三角形もセルとして、裏側の四面体の値とともに書き出します。オフの場合、元のファイルにそうした三角形がない限り、.vtu と .vtk には四面体だけが入ります</translation>
    </message>
    <message>
        <source>&amp;Border triangles</source>
        <translation>境界の三角形(&amp;B)</translation>
    </message>
    <message>
        <source>how the picture is sampled</source>
        <translation>画像のサンプリング方法</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>補間(&amp;T)</translation>
    </message>
    <message>
        <source>Nearest – hard pixels</source>
        <translation>ニアレストネイバー – ハードなピクセル</translation>
    </message>
    <message>
        <source>Bilinear – quick</source>
        <translation>バイリニア – 高速</translation>
    </message>
    <message>
        <source>Bicubic – sharp</source>
        <translation>バイキュービック – シャープ</translation>
    </message>
    <message>
        <source>EWA – best</source>
        <translation>EWA – 最高品質</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>キャンバス(&amp;C)</translation>
    </message>
    <message>
        <source>As large as the picture</source>
        <translation>画像と同じサイズ</translation>
    </message>
    <message>
        <source>Fit to the shape</source>
        <translation>形状に合わせる</translation>
    </message>
    <message>
        <source>bits per channel in pictures: as in the source, 8 or 16, or half or full floating point; values stay what they are</source>
        <translation>画像のチャンネルあたりのビット数：元画像と同じ、8、16、または半精度・単精度の浮動小数点数。値は変わりません</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>ビット深度(&amp;D)</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>画像と同じ</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 bit</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 bit</translation>
    </message>
    <message>
        <source>16 bit floating point (half)</source>
        <translation>16 bit 浮動小数点（half）</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 bit 浮動小数点</translation>
    </message>
    <message>
        <source>what pictures show around the shape: nothing, its border drawn outwards, the source as it was, or a colour</source>
        <translation>形状の外側に写るもの：なし、引き伸ばした縁、元画像、または単色</translation>
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
        <translation>縁を引き伸ばす</translation>
    </message>
    <message>
        <source>The picture as it was</source>
        <translation>元画像のまま</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黒</translation>
    </message>
    <message>
        <source>How far apart growing the outline keeps parts and limbs, so that they do not become one.</source>
        <translation>広げるときに各部や手足をこれだけ離しておき、一つにくっつかないようにします。</translation>
    </message>
    <message>
        <source>Change gap</source>
        <translation>すき間を変更</translation>
    </message>
    <message>
        <source>Parts and holes of fewer pixels, such as dust around a drawing, are left out.</source>
        <translation>これより画素の少ない部分や穴（絵のまわりのごみなど）は除かれます。</translation>
    </message>
    <message>
        <source>Change what is left out</source>
        <translation>除くものを変更</translation>
    </message>
    <message>
        <source>&amp;Gap</source>
        <translation>すき間(&amp;G)</translation>
    </message>
    <message>
        <source>Drop &amp;below</source>
        <translation>最小の面積(&amp;B)</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>上向きの軸を変更</translation>
    </message>
    <message>
        <source>pixels that pictures show: those of the source, as many as the shape needs, or those of a rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it</source>
        <translation>画像に含まれるピクセル：元画像と同じ範囲、形状に必要な範囲、または元画像の矩形 X,Y,幅,高さ（元画像からはみ出してもよい）</translation>
    </message>
    <message>
        <source>Another colour …</source>
        <translation>ほかの色…</translation>
    </message>
    <message>
        <source>R&amp;ate</source>
        <translation>フレームレート(&amp;S)</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>whether WebP pictures and films keep every pixel, or are a fraction of the size with hardly visible losses</source>
        <translation>WebP の画像と映像ですべての画素を保つか、ほとんど見えない劣化でサイズをずっと小さくするか</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>品質(&amp;Q)</translation>
    </message>
    <message>
        <source>Every pixel – lossless</source>
        <translation>すべての画素 – 劣化なし</translation>
    </message>
    <message>
        <source>Smaller file – lossy</source>
        <translation>小さいファイル – 劣化あり</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>元の形に戻る力</translation>
    </message>
    <message>
        <source>Lead a pin around and back: how far does the shape come back, too? Not at all: where it ends depends on the path. Fully: it is as it was.</source>
        <translation>ピンをぐるりと動かして元の位置に戻したとき、形がどこまで元に戻るかです。なし：最後の形は通った道筋で変わります。完全：元の形に戻ります。</translation>
    </message>
    <message>
        <source>Change springing back</source>
        <translation>元の形に戻る力を変更</translation>
    </message>
    <message>
        <source>Opa&amp;que from</source>
        <translation>不透明とみなす値(&amp;Q)</translation>
    </message>
    <message>
        <source>Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid).</source>
        <translation>「保持」を表す数値 φ。プロジェクトファイルと同じ値です。0.002 は面積または体積、0.464 は長さ、1.571 は剛体、2.678 は角度（ソリッドでは 2.498）を保ちます。</translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, this with what its lines enclose, or the picture as a whole.</source>
        <translation>曲がる範囲：画像の不透明な部分だけ、それに線で囲まれた内側を加えたもの、または画像全体。</translation>
    </message>
    <message>
        <source>Cut-out, holes filled</source>
        <translation>切り抜き（穴を埋める）</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>ソルバーを変更</translation>
    </message>
    <message>
        <source>frames per second of a film; a unit of time is a second</source>
        <translation>フィルムの 1 秒あたりのフレーム数。時間の単位は 1 秒です</translation>
    </message>
    <message>
        <source>Change frame rate</source>
        <translation>フレームレートを変更</translation>
    </message>
    <message>
        <source>leave the last frame out, which is the first one again: for films that repeat; if the project has a cycle, show that</source>
        <translation>最初と同じになる最後のフレームを省きます。繰り返すフィルム用です。プロジェクトにサイクルがあれば、それを表示します</translation>
    </message>
    <message>
        <source>Loop: no fra&amp;me twice</source>
        <translation>ループ：同じフレームを繰り返さない(&amp;M)</translation>
    </message>
    <message>
        <source>size of pictures in percent of the canvas; that of frames becomes even</source>
        <translation>キャンバスに対する画像の大きさ（パーセント）。フレームの大きさは偶数になります</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>大きさ(&amp;S)</translation>
    </message>
    <message>
        <source>width of pictures, instead of a size in percent</source>
        <translation>パーセントの代わりに指定する画像の幅</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>幅(&amp;W)</translation>
    </message>
    <message>
        <source>Inner she&amp;lls</source>
        <translation>内側の殻(&amp;L)</translation>
    </message>
    <message>
        <source>What is inside of shells that lie one in the other: holes, or regions of their own, whose cells are labelled. Bodies that share walls are all filled and labelled.</source>
        <translation>入れ子になった殻の内側を、穴にするか、セルにラベルの付いた個別の領域にするか。壁を共有する物体はすべて満たされ、ラベルが付きます。</translation>
    </message>
    <message>
        <source>Change inner shells</source>
        <translation>内側の殻を変更</translation>
    </message>
    <message>
        <source>Holes, and say so</source>
        <translation>穴(知らせる)</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>領域</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>Draw around what should bend, too; Ctrl takes it away, Esc cancels</source>
        <translation>一緒に変形させる部分を囲みます。Ctrl で除外、Esc で中止</translation>
    </message>
    <message>
        <source>Brush over what should bend, too; Ctrl takes it away, [ and ] change the size</source>
        <translation>一緒に変形させる部分をブラシでなぞります。[ と ] でサイズを変更、Ctrl で除外</translation>
    </message>
    <message>
        <source>Click a colour that should bend, too; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>一緒に変形させる色をクリックします。Ctrl で除外、[ と ] で色の範囲を狭く、または広く</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape; Esc cancels</source>
        <translation>線を引くと、そこで形状が切り離されます。Esc で中止</translation>
    </message>
    <message>
        <source>Nothing would be left of the shape.</source>
        <translation>形状が何も残らなくなります。</translation>
    </message>
    <message numerus="yes">
        <source>Pins outside the new outline were removed: %n.</source>
        <translation>
            <numerusform>新しい輪郭の外にあった %n 個のピンを削除しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り離し</translation>
    </message>
    <message>
        <source>Take away from the outline</source>
        <translation>輪郭から除外</translation>
    </message>
    <message>
        <source>Add to the outline</source>
        <translation>輪郭に追加</translation>
    </message>
    <message>
        <source>The tolerance, or [ and ], changes what was taken; click another colour to take it too, with Ctrl to take it away</source>
        <translation>許容値（[ と ] でも）を変えると、取った範囲が変わります。別の色をクリックで追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>That was a line. Draw around a part of the picture.</source>
        <translation>線になっています。画像の一部を囲んでください。</translation>
    </message>
    <message>
        <source>From now on the outline is as you draw it, and has no margin to change. Choose “Cut-out” as the outline to go back to the one that was found.</source>
        <translation>これ以降、輪郭は描いたとおりになり、余白の設定はありません。輪郭を「切り抜き」にすると、自動で見つけた輪郭に戻ります。</translation>
    </message>
    <message>
        <source>Draw around what should bend; Ctrl takes it away, Esc cancels</source>
        <translation>変形させる部分を囲みます。Ctrl で除外、Esc で中止</translation>
    </message>
    <message>
        <source>Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl takes away, Backspace removes the last corner, Esc cancels</source>
        <translation>角を順にクリックし（Shift で 45° 刻み）、ダブルクリックで閉じます。Ctrl で除外、Backspace で角を 1 つ戻す、Esc で中止</translation>
    </message>
    <message>
        <source>Brush over what should bend; Ctrl takes it away, [ and ] change the size</source>
        <translation>変形させる部分をブラシでなぞります。[ と ] でサイズを変更、Ctrl で除外</translation>
    </message>
    <message>
        <source>Click a colour that should bend; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>変形させる色をクリックします。Ctrl で除外、[ と ] で色の範囲を狭く、または広く</translation>
    </message>
    <message>
        <source>Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels</source>
        <translation>独立したパーツにする部分を、残りとつながる所まで囲みます。Esc で取り消し</translation>
    </message>
    <message>
        <source>This picture has parts: choose the one in the list that this outline is for, or Make a Part to cut another one out.</source>
        <translation>この画像にはパーツがあります。リストでこの輪郭の対象を選ぶか、「パーツにする」でさらに切り抜いてください。</translation>
    </message>
    <message>
        <source>“%1” is locked. The list of parts unlocks it.</source>
        <translation>「%1」はロックされています。パーツのリストで解除できます。</translation>
    </message>
</context>
<context>
    <name>PaintTool</name>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>剛体</translation>
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
        <translation>体積</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Combed</source>
        <translation>コーム</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>平滑化</translation>
    </message>
    <message>
        <source>Erase paint from %1</source>
        <translation>%1 のペイントを消去</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 を平滑化</translation>
    </message>
    <message>
        <source>Comb %1</source>
        <translation>%1 をコーム</translation>
    </message>
    <message>
        <source>Paint %1 on %2</source>
        <translation>%2 に「%1」をペイント</translation>
    </message>
    <message>
        <source>There is no direction to follow: the numbers on the right were used.</source>
        <translation>たどる方向がないため、右側の数値を使いました。</translation>
    </message>
    <message>
        <source>Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>剛性を持たせる方向に、髪をとかすように描きます。Ctrl で消去、Shift で平滑化、Shift + クリックで直線、Alt + クリックで取得、Esc でストロークを中止</translation>
    </message>
    <message>
        <source>Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>右側で選んだものをペイントします。Ctrl で消去、Shift で平滑化、Shift + クリックで直線、Alt + クリックで取得、Esc でストロークを中止</translation>
    </message>
    <message>
        <source>Stiffness ×1 is the same as everywhere and changes nothing: choose on the right how many times stiffer it should be</source>
        <translation>剛性 ×1 はほかと同じで、ここでは何も変わりません。右で何倍の剛性にするかを選んでください</translation>
    </message>
    <message>
        <source>Erase paint</source>
        <translation>ペイントを消去</translation>
    </message>
    <message>
        <source>Erases paint from all visible layers: brush over what should be like the rest again; Shift-click draws a line, Esc cancels the stroke</source>
        <translation>表示中のすべてのレイヤーからペイントを消去します。ほかと同じに戻す部分をブラシでなぞります。Shift+クリックで直線、Esc でストロークを中止</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑化</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>コーム</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>「%1」をペイント</translation>
    </message>
    <message>
        <source>Nothing is painted there</source>
        <translation>そこには何もペイントされていません</translation>
    </message>
</context>
<context>
    <name>PanTool</name>
    <message>
        <source>Drag to move the view; the wheel zooms</source>
        <translation>ドラッグで表示を移動、ホイールでズーム</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>There is nothing of the picture in this area.</source>
        <translation>この範囲には画像がありません。</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>パーツ %1</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>パーツにする</translation>
    </message>
    <message>
        <source>“%1” is a part now, joined to “%2” where it hangs on it. What is behind it is being filled.</source>
        <translation>「%1」はパーツになり、「%2」につながる所で結合されました。背後を補完しています。</translation>
    </message>
    <message>
        <source>“%1” is a part now, cut from “%2”. What is behind it is being filled. Pin it, or join it under Parts.</source>
        <translation>「%1」は「%2」から切り出されたパーツになりました。背後を補完しています。ピンで留めるか、「パーツ」で結合してください。</translation>
    </message>
    <message>
        <source>In this area is nothing but what is locked, if anything. The list of parts unlocks it.</source>
        <translation>この範囲にはロックされたものしかありません。パーツのリストで解除できます。</translation>
    </message>
    <message>
        <source>The parts are still being made. Another one can be made as soon as they are there.</source>
        <translation>パーツを作成中です。できあがると次のパーツを作成できます。</translation>
    </message>
</context>
<context>
    <name>PenTool</name>
    <message>
        <source>Click the pin whose path you want to draw</source>
        <translation>パスを描きたいピンをクリック</translation>
    </message>
    <message>
        <source>Click where the selected pin should go, point by point; drag for a smooth point</source>
        <translation>選択したピンの行き先を一点ずつクリック。ドラッグで滑らかな点</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, Shift snaps to 45°; Enter ends, Backspace removes the last point, Esc cancels</source>
        <translation>クリックで角、ドラッグで滑らかな点、Shift で 45° 刻み。Enter で終了、Backspace で一点戻る、Esc で中止</translation>
    </message>
    <message>
        <source>Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only</source>
        <translation>ドラッグで滑らかな点になります。Shift で 45° に固定、Ctrl または Alt でこちら側だけ動きます</translation>
    </message>
</context>
<context>
    <name>PictureTip</name>
    <message>
        <source>near</source>
        <translation>近く</translation>
    </message>
    <message>
        <source>far</source>
        <translation>遠く</translation>
    </message>
    <message>
        <source>×1 everywhere</source>
        <translation>全体が ×1</translation>
    </message>
    <message>
        <source>×50 along the left half</source>
        <translation>左半分に沿って ×50</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>完全</translation>
    </message>
    <message>
        <source>as it was pulled</source>
        <translation>引いたまま</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>緩めた後</translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag as far as the pin should hold; Esc cancels</source>
        <translation>ピンがつかむ大きさまでドラッグします。Esc で中止</translation>
    </message>
    <message>
        <source>Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number</source>
        <translation>点をドラッグで回転（Shift で 15° 刻み）、四角をドラッグで拡大・縮小。数字キーで数値を入力できます</translation>
    </message>
    <message>
        <source>%1: holds from %2 s</source>
        <translation>%1: %2 秒から固定</translation>
    </message>
    <message>
        <source>%1: released at %2 s</source>
        <translation>%1: %2 秒で解放</translation>
    </message>
    <message>
        <source>Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl records it; digits set the number</source>
        <translation>どこでもドラッグで選択を回転、Shift で 15° ずつ、Ctrl で記録。数字キーで値を指定</translation>
    </message>
    <message>
        <source>Drag anywhere to scale what is selected, Ctrl records it; digits set the number</source>
        <translation>どこでもドラッグで選択を拡大・縮小、Ctrl で記録。数字キーで値を指定</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; G moves, R rotates, S scales</source>
        <translation>矢印、四角、リングをドラッグします。G で移動、R で回転、S で拡大・縮小</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, draw around pins to select them</source>
        <translation>形状をクリックしてピンを打ち、ドラッグですぐに変形。形状の外からはピンを囲んで選択します</translation>
    </message>
    <message>
        <source>Draw around pins to select them; Shift adds, Ctrl takes away</source>
        <translation>ピンを囲んで選択します。Shift で追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, brush over pins, [ and ] change the size</source>
        <translation>形状をクリックしてピンを打ち、ドラッグですぐに変形。形状の外からはピンをブラシでなぞります。[ と ] でサイズを変更</translation>
    </message>
    <message>
        <source>Brush over pins to select them, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>ピンをブラシでなぞって選択します。[ と ] でサイズを変更、Shift で追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, or press and drag to bend it at once</source>
        <translation>形状をクリックしてピンを打つか、押したままドラッグしてすぐに変形させます</translation>
    </message>
    <message>
        <source>Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move</source>
        <translation>クリック、またはピンの横から囲んで選択。Shift で追加、Ctrl で除外。ドラッグまたは矢印キーで移動</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y, Z lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Shift でまっすぐに移動、X、Y、Z で軸を固定、数字で量を入力、Esc で形状を元に戻します</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Shift でまっすぐに移動、X、Y で軸を固定、数字で量を入力、Esc で形状を元に戻します</translation>
    </message>
    <message>
        <source>Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, Shift-click to select more</source>
        <translation>ドラッグでピンを移動、Ctrl+ドラッグで記録、Ctrl+Shift+ドラッグで広げます。Shift+クリックで追加選択</translation>
    </message>
    <message>
        <source>Drag to scale: the point becomes a small circle</source>
        <translation>ドラッグで拡大・縮小します。点は小さな円になります</translation>
    </message>
    <message>
        <source>Drag to rotate: the point becomes a small circle, which holds its angle</source>
        <translation>ドラッグで回転します。点は角度を保つ小さな円になります</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>Choose one in the list first.</source>
        <translation>先に一覧から選んでください。</translation>
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
        <translation>離すまでの動きがそのまま記録されます。Esc で中止します</translation>
    </message>
</context>
<context>
    <name>RegionTool</name>
    <message>
        <source>Drag from a point on the surface to hold a ball; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>表面の点からドラッグして球でつかみます。Shift で中身を選択中のハンドルに追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>Drag from a point on the surface towards the side to hold: all that lies beyond the point</source>
        <translation>表面の点から、つかむ側へドラッグします。その点より先がすべて対象になります</translation>
    </message>
    <message>
        <source>Drag from a point on the surface to hold a box; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>表面の点からドラッグして直方体でつかみます。Shift で中身を選択中のハンドルに追加、Ctrl で除外</translation>
    </message>
    <message>
        <source>There is no vertex in this region.</source>
        <translation>この領域に頂点はありません。</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>領域</translation>
    </message>
</context>
<context>
    <name>SampleNames</name>
    <message>
        <source>back</source>
        <translation>背中</translation>
    </message>
    <message>
        <source>body</source>
        <translation>体</translation>
    </message>
    <message>
        <source>face</source>
        <translation>顔</translation>
    </message>
    <message>
        <source>far front hoof</source>
        <translation>奥の前足</translation>
    </message>
    <message>
        <source>far hind hoof</source>
        <translation>奥の後ろ足</translation>
    </message>
    <message>
        <source>front hoof</source>
        <translation>前足</translation>
    </message>
    <message>
        <source>head</source>
        <translation>頭</translation>
    </message>
    <message>
        <source>hind hoof</source>
        <translation>後ろ足</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>左ひじ</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>左目</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左足</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>左下の腕</translation>
    </message>
    <message>
        <source>left middle arm</source>
        <translation>左中の腕</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>左上の腕</translation>
    </message>
    <message>
        <source>left wing</source>
        <translation>左の翼</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>右目</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右足</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>右下の腕</translation>
    </message>
    <message>
        <source>right middle arm</source>
        <translation>右中の腕</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>右上の腕</translation>
    </message>
    <message>
        <source>right wing</source>
        <translation>右の翼</translation>
    </message>
    <message>
        <source>rump</source>
        <translation>お尻</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>肩</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>硬い部分</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>しっぽ</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>胸</translation>
    </message>
    <message>
        <source>far hand</source>
        <translation>奥の手</translation>
    </message>
    <message>
        <source>far heel</source>
        <translation>奥のかかと</translation>
    </message>
    <message>
        <source>far toe</source>
        <translation>奥のつま先</translation>
    </message>
    <message>
        <source>near hand</source>
        <translation>手前の手</translation>
    </message>
    <message>
        <source>near heel</source>
        <translation>手前のかかと</translation>
    </message>
    <message>
        <source>near toe</source>
        <translation>手前のつま先</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>影</translation>
    </message>
</context>
<context>
    <name>SizeTool</name>
    <message>
        <source>Brush over what should be meshed finer; Shift makes it coarser, Ctrl evens it out again, [ and ] change the size</source>
        <translation>メッシュを細かくする部分をブラシでなぞります。Shift で粗く、Ctrl で均一に戻し、[ と ] でサイズを変更</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>メッシュはファイルから読み込まれ、そのまま使われます。</translation>
    </message>
    <message>
        <source>Paint finer mesh</source>
        <translation>メッシュを細かくペイント</translation>
    </message>
    <message>
        <source>Paint coarser mesh</source>
        <translation>メッシュを粗くペイント</translation>
    </message>
    <message>
        <source>Paint even mesh</source>
        <translation>メッシュを均一にペイント</translation>
    </message>
</context>
<context>
    <name>StiffnessFields</name>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
</context>
<context>
    <name>StrokeTool</name>
    <message>
        <source>To the right: larger; up: harder. Esc leaves it as it was</source>
        <translation>右へ：大きく、上へ：硬く。Esc で元のまま</translation>
    </message>
    <message>
        <source>%1 px · %2 % hard</source>
        <translation>%1 px · 硬さ %2 %</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>&amp;Pin</source>
        <translation>ピン(&amp;P)</translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation>ピンを打ってドラッグします</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>選択(&amp;L)</translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation>新しいピンを打たずに、ピンを選択してドラッグします</translation>
    </message>
    <message>
        <source>Grab by &amp;Lasso</source>
        <translation>なげなわでつかむ(&amp;L)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a drawn outline as one handle</source>
        <translation>描いた輪郭の内側すべてを 1 つのハンドルとしてつかみます</translation>
    </message>
    <message>
        <source>Grab by Bo&amp;x</source>
        <translation>長方形でつかむ(&amp;X)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a rectangle as one handle</source>
        <translation>長方形の内側すべてを 1 つのハンドルとしてつかみます</translation>
    </message>
    <message>
        <source>Grab by &amp;Brush</source>
        <translation>ブラシでつかむ(&amp;B)</translation>
    </message>
    <message>
        <source>Take hold of what is brushed over as one handle</source>
        <translation>ブラシでなぞった部分を 1 つのハンドルとしてつかみます</translation>
    </message>
    <message>
        <source>Grab a B&amp;all</source>
        <translation>球でつかむ(&amp;A)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a ball around a point on the surface</source>
        <translation>表面の点を中心とする球の中をすべてつかみます</translation>
    </message>
    <message>
        <source>Grab a Bloc&amp;k</source>
        <translation>直方体でつかむ(&amp;K)</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a block around a point on the surface</source>
        <translation>表面の点を中心とする直方体の中をすべてつかみます</translation>
    </message>
    <message>
        <source>Grab &amp;One Side</source>
        <translation>片側をつかむ(&amp;O)</translation>
    </message>
    <message>
        <source>Take hold of all that lies beyond a plane through a point on the surface</source>
        <translation>表面の点を通る平面の向こう側をすべてつかみます</translation>
    </message>
    <message>
        <source>Outline by &amp;Lasso</source>
        <translation>なげなわで輪郭を描く(&amp;L)</translation>
    </message>
    <message>
        <source>Draw around what should bend, or should not</source>
        <translation>変形させる部分、またはさせない部分を囲みます</translation>
    </message>
    <message>
        <source>Outline by &amp;Polygon</source>
        <translation>多角形で輪郭を描く(&amp;P)</translation>
    </message>
    <message>
        <source>Set the corners of what should bend, or should not</source>
        <translation>変形させる部分、またはさせない部分の角を指定します</translation>
    </message>
    <message>
        <source>Outline by &amp;Brush</source>
        <translation>ブラシで輪郭を描く(&amp;B)</translation>
    </message>
    <message>
        <source>Brush over what should bend, or should not</source>
        <translation>変形させる部分、またはさせない部分をブラシでなぞります</translation>
    </message>
    <message>
        <source>Click a colour that should bend, or should not</source>
        <translation>変形させる色、またはさせない色をクリックします</translation>
    </message>
    <message>
        <source>Cut &amp;Apart</source>
        <translation>切り離す(&amp;A)</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape</source>
        <translation>線を引いて、そこで形状を切り離します</translation>
    </message>
    <message>
        <source>&amp;Detail Brush</source>
        <translation>細かさブラシ(&amp;D)</translation>
    </message>
    <message>
        <source>Brush where the mesh should be finer or coarser</source>
        <translation>メッシュを細かくする、または粗くする部分をブラシでなぞります</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>ペイント(&amp;P)</translation>
    </message>
    <message>
        <source>Paint what is kept, or how stiff it is</source>
        <translation>保持するもの、または剛性をペイントします</translation>
    </message>
    <message>
        <source>&amp;Comb</source>
        <translation>コーム(&amp;C)</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>剛性の方向を、髪をとかすように描きます</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>グラデーション(&amp;G)</translation>
    </message>
    <message>
        <source>Drag to blend evenly from what is there to what is chosen</source>
        <translation>ドラッグ：今の状態から選んだものへ均一に変化します</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>塗りつぶし(&amp;F)</translation>
    </message>
    <message>
        <source>Fill a connected area with what is chosen</source>
        <translation>つながった部分全体を、選んだもので塗りつぶします</translation>
    </message>
    <message>
        <source>E&amp;yedropper</source>
        <translation>スポイト(&amp;Y)</translation>
    </message>
    <message>
        <source>Pick up what is painted under the pointer</source>
        <translation>ポインターの位置のペイントを取得します</translation>
    </message>
    <message>
        <source>Depth Brus&amp;h</source>
        <translation>奥行きブラシ(&amp;H)</translation>
    </message>
    <message>
        <source>Brush over what lies in front where the shape covers itself</source>
        <translation>形状が重なるところで、手前にくる部分をブラシでなぞります</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>計測(&amp;E)</translation>
    </message>
    <message>
        <source>Measure lengths and angles between points of the shape</source>
        <translation>形状上の点の間の長さと角度を測ります</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>消しゴム(&amp;R)</translation>
    </message>
    <message>
        <source>Erase paint: what you brush over is like the rest again</source>
        <translation>ペイントを消します：なぞった部分はほかと同じに戻ります</translation>
    </message>
    <message>
        <source>&amp;Crop</source>
        <translation>切り抜き(&amp;C)</translation>
    </message>
    <message>
        <source>Draw a rectangle around the part of the picture that exports keep</source>
        <translation>書き出しで画像から残す範囲を四角で囲む</translation>
    </message>
    <message>
        <source>Pe&amp;n</source>
        <translation>ペン(&amp;N)</translation>
    </message>
    <message>
        <source>Draw the path of a pin, point by point</source>
        <translation>ピンのパスを一点ずつ描く</translation>
    </message>
    <message>
        <source>Pa&amp;n</source>
        <translation>表示を移動(&amp;N)</translation>
    </message>
    <message>
        <source>Drag the view to another place; in every step, holding the space bar does so, too</source>
        <translation>表示を別の場所へドラッグ。どの段階でもスペースキーでできます</translation>
    </message>
    <message>
        <source>Magic &amp;Wand</source>
        <translation>マジックワンド(&amp;W)</translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>This picture is no SVG drawing: its pixels are what it has.</source>
        <translation>この画像は SVG の図ではないため、ピクセル数は決まっています。</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a picture, a mesh, a surface or a project</source>
        <translation>画像、メッシュ、サーフェス、プロジェクトを開きます</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>プロジェクトを保存します</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>別名で保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>プロジェクトを別の名前で保存します</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>画像(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the bent picture at its full size</source>
        <translation>現在の変形状態の画像を実寸で書き出します</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Sequence…</source>
        <translation>連番(&amp;S)…</translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures or meshes</source>
        <translation>モーションを画像またはメッシュの連番として書き出します</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation>各ピクセルの元の位置を、コンポジットソフト用に書き出します</translation>
    </message>
    <message>
        <source>&amp;Mesh…</source>
        <translation>メッシュ(&amp;M)…</translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation>変形したメッシュを OBJ、PLY、VTU… として書き出します</translation>
    </message>
    <message>
        <source>&amp;View…</source>
        <translation>ビュー(&amp;V)…</translation>
    </message>
    <message>
        <source>Write the view as a picture, as large as you like</source>
        <translation>ビューを好きな大きさの画像として書き出します</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>書き出し(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation>ファイルを閉じてスタートページに戻ります</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation>Wend を終了します</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近使ったファイルを開く(&amp;R)</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>サンプルを開く(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>取り消し(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直し(&amp;R)</translation>
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
        <translation>直前の操作を取り消します</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>取り消した操作をやり直します</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation>すべてのピンを選択(&amp;A)</translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation>すべてのピンを選択します</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>選択を解除(&amp;N)</translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation>ピンの選択を解除します</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>ピンを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation>選択したピンを削除します。すでに動いた部分はそのまま残ります</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Colour the shape by what changed</source>
        <translation>形状を変化量で色分けします</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>&amp;Stiffness Marks</source>
        <translation>剛性マーク(&amp;S)</translation>
    </message>
    <message>
        <source>Show where the shape is stiff, and along which direction</source>
        <translation>剛性のある場所とその方向を表示します</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation>画像だけを表示します。H を押している間だけの表示もできます</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>変形前(&amp;B)</translation>
    </message>
    <message>
        <source>Show the shape as it was before it was bent; hold \ to do so for a moment</source>
        <translation>変形前の形状を表示します。\ を押している間だけの表示もできます</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>全体表示(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>画像全体を表示します</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation>等倍表示(&amp;A)</translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation>画像の 1 ピクセルを画面の 1 ピクセルで表示します</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>ズームイン(&amp;I)</translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation>拡大して表示します</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>ズームアウト(&amp;O)</translation>
    </message>
    <message>
        <source>See more</source>
        <translation>広い範囲を表示します</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>フルスクリーン(&amp;S)</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>画面全体を使います</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>デスクトップに合わせる(&amp;D)</translation>
    </message>
    <message>
        <source>Light or dark, like the desktop</source>
        <translation>デスクトップの明暗に合わせます</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>明るい背景に暗い文字</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>暗い背景に明るい文字</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>ループ(&amp;L)</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>最後まで再生したら最初に戻ります</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>先頭へ(&amp;S)</translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation>変形前の形状を表示します</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>末尾へ(&amp;E)</translation>
    </message>
    <message>
        <source>Show the end of the motion</source>
        <translation>モーションの最後を表示します</translation>
    </message>
    <message>
        <source>Let the shape relax at the end, with the pins where they are</source>
        <translation>モーションの最後で、ピンの位置は変えずに形状を元の形へ近づけます</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>How it works, page by page, with a search</source>
        <translation>使い方をページごとに説明します（検索付き）</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>キーとマウス(&amp;K)</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>マウスとキーの働きを表示します</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation>Wend について(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>バージョンとライセンス</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>外観(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>ツール(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>モーション(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>まず画像を開いてください。</translation>
    </message>
    <message>
        <source>A solid has no pixels.</source>
        <translation>ソリッドにはピクセルがありません。</translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation>このプロジェクトには画像がありません。</translation>
    </message>
    <message>
        <source>A solid has no pixels: export the view.</source>
        <translation>ソリッドにはピクセルがありません。ビューを書き出してください。</translation>
    </message>
    <message>
        <source>For a picture, export the picture itself.</source>
        <translation>画像の場合は、画像そのものを書き出してください。</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>まずピンを選択してください。</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>まだ何も動いていません。ピンをドラッグしてください。</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>チュートリアル(&amp;T)</translation>
    </message>
    <message>
        <source>The first five minutes, on a sample, step by step</source>
        <translation>最初の 5 分間を、サンプルを使って順を追って案内します</translation>
    </message>
    <message>
        <source>&amp;Velocity Arrows</source>
        <translation>速度の矢印(&amp;V)</translation>
    </message>
    <message>
        <source>Show where the shape moves at this time</source>
        <translation>この時点で形状がどこへ動くかを表示します</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>&amp;Compare Energies</source>
        <translation>エネルギーを比較(&amp;C)</translation>
    </message>
    <message>
        <source>Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape</source>
        <translation>同じピンで別のエネルギーを使った結果を横に表示します。「保持」のタイルを形状にドラッグしてもできます</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>記録(&amp;R)</translation>
    </message>
    <message>
        <source>Record every drag as it happens, in real time; Ctrl does so for one drag</source>
        <translation>すべてのドラッグを実時間のまま記録します。Ctrl を押すと 1 回だけ記録します</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation>オニオンスキン(&amp;O)</translation>
    </message>
    <message>
        <source>Show the shape as it was a little before and as it is a little after</source>
        <translation>少し前と少し後の形を表示します</translation>
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
        <translation>再生の速さと、記録に使う時計の速さ</translation>
    </message>
    <message>
        <source>Speed: %1 %</source>
        <translation>速度: %1 %</translation>
    </message>
    <message>
        <source>Play or pause the motion; tapping the space bar does so, too</source>
        <translation>動きを再生または一時停止します。スペースキーを軽く押しても同じです</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>プロパティ(&amp;P)</translation>
    </message>
    <message>
        <source>Show the properties on the right, or give their room to the shape</source>
        <translation>右側にプロパティを表示、または形状のために場所をあける</translation>
    </message>
    <message>
        <source>Size of M&amp;arks</source>
        <translation>マークの大きさ(&amp;A)</translation>
    </message>
    <message>
        <source>How large pins, rings and curves are drawn, so that they are easy to see and to hit</source>
        <translation>形状の上のピン、リング、曲線の大きさ。見やすさとつかみやすさのために</translation>
    </message>
    <message>
        <source>Rela&amp;x</source>
        <translation>緩める(&amp;X)</translation>
    </message>
    <message>
        <source>ST &amp;Map…</source>
        <translation>ST マップ(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>ヒストリー(&amp;H)…</translation>
    </message>
    <message>
        <source>Show the undo history, and go back to any step</source>
        <translation>操作の履歴を表示し、任意の段階に戻ります</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>エッジ(&amp;E)</translation>
    </message>
    <message>
        <source>Show the edges of the mesh</source>
        <translation>メッシュのエッジを表示します</translation>
    </message>
    <message>
        <source>&amp;Colour Overlay</source>
        <translation>カラーオーバーレイ(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Overlays</source>
        <translation>ピンとオーバーレイを隠す(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>フィルム(&amp;F)…</translation>
    </message>
    <message>
        <source>Write the motion as a film: MP4, WebM, QuickTime, GIF …</source>
        <translation>動きをフィルムとして書き出します：MP4、WebM、QuickTime、GIF など</translation>
    </message>
    <message>
        <source>&amp;Pose at This Time</source>
        <translation>この時刻のポーズ(&amp;P)</translation>
    </message>
    <message>
        <source>In the step Animate, a drag sets where pins are at the time shown, and what they do before and after stays; off: it leads them on to the end of the film</source>
        <translation>「アニメート」の段階では、ドラッグで表示時刻のピンの位置が決まり、前後の動きはそのままです。オフのときはフィルムの終わりまで動かし続けます</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>パーツにする(&amp;P)</translation>
    </message>
    <message>
        <source>What is drawn as the outline becomes a part that bends by itself, or what you draw next; what is behind it is filled</source>
        <translation>輪郭として描いた部分、または次に描く部分が、単独で曲がるパーツになります。背後は補完されます</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Keep the Pa&amp;th</source>
        <translation>経路を残す(&amp;W)</translation>
    </message>
    <message>
        <source>Re&amp;place Picture…</source>
        <translation>画像を置き換え(&amp;P)…</translation>
    </message>
    <message>
        <source>Bend another picture of the same proportions in the place of this one; pins and motions stay, and are scaled if it is larger or smaller</source>
        <translation>縦横比が同じ別の画像に置き換えて曲げます。ピンと動きは残り、大きさが違えば拡大縮小されます</translation>
    </message>
    <message>
        <source>&amp;Apply Motion…</source>
        <translation>動きを適用(&amp;A)…</translation>
    </message>
    <message>
        <source>Move this shape as another project moves its own: pins of the same name, with lengths in proportion to the sizes of both shapes</source>
        <translation>他のプロジェクトと同じようにこの形を動かします。同名のピンを使い、長さは両方の形の大きさの比に合わせます</translation>
    </message>
    <message>
        <source>A drag that follows another of the same pins at the end of the film leads them on by a second; off: it corrects that move, which becomes straight</source>
        <translation>フィルムの最後で同じピンを続けてドラッグすると、さらに1秒先へ動かします。オフ: 前の動きを直し、まっすぐにします</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>キーボードショートカット(&amp;K)…</translation>
    </message>
    <message>
        <source>Give actions other keys</source>
        <translation>操作に別のキーを割り当てます</translation>
    </message>
    <message>
        <source>&amp;Drawing Size…</source>
        <translation>図の大きさ(&amp;D)…</translation>
    </message>
    <message>
        <source>Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it</source>
        <translation>SVG の図を描くピクセル数を変えます。ピンと動きも拡大縮小されます</translation>
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
        <translation>市松模様(&amp;C)</translation>
    </message>
    <message>
        <source>Checks behind a picture, the workspace behind a solid</source>
        <translation>画像の後ろは市松模様、立体の後ろは作業領域</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>白(&amp;W)</translation>
    </message>
    <message>
        <source>White behind the shape, to see dark edges</source>
        <translation>形の後ろを白に: 暗い縁が見えます</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>灰色(&amp;G)</translation>
    </message>
    <message>
        <source>Grey behind the shape</source>
        <translation>形の後ろを灰色に</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>黒(&amp;B)</translation>
    </message>
    <message>
        <source>Black behind the shape, to see light edges</source>
        <translation>形の後ろを黒に: 明るい縁が見えます</translation>
    </message>
</context>
<context>
    <name>wend::BalancePanel</name>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>このプロジェクトの平滑化は論文と同じ λ によるもので、強さはファイルに書かれています。</translation>
    </message>
</context>
<context>
    <name>wend::BrushActions</name>
    <message>
        <source>&amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>%1 をペイント</translation>
    </message>
    <message>
        <source>Choose the step “Paint” first.</source>
        <translation>まず「ペイント」のステップを選んでください。</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>保持(&amp;K)</translation>
    </message>
    <message>
        <source>Paint what the shape keeps when it has to give way</source>
        <translation>変形するときに形状が保とうとするものをペイントします</translation>
    </message>
    <message>
        <source>&amp;Stiffness</source>
        <translation>剛性(&amp;S)</translation>
    </message>
    <message>
        <source>Paint how many times stiffer the shape is along a direction</source>
        <translation>ある方向に沿って何倍の剛性にするかをペイントします</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>剛性の方向を、髪をとかすように描きます</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ], or by dragging to the right with Alt and the right button.</source>
        <translation>画面上でのブラシの直径。[ と ] のキー、または Alt+右ボタンで右へドラッグしても変更できます。</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>硬さ</translation>
    </message>
    <message>
        <source>How much of the brush paints fully; beyond that it fades out. Also by Shift with [ and ], or by dragging upwards with Alt and the right button.</source>
        <translation>ブラシのうち完全に塗られる部分の割合。その外側は薄れていきます。Shift と [ または ]、または Alt+右ボタンで上へドラッグしても変更できます。</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>How far a stroke goes from what is there to what is painted.</source>
        <translation>1 回のストロークで、今の状態をペイントする値へどれだけ近づけるか。</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>筆圧(&amp;P)</translation>
    </message>
    <message>
        <source>The harder a pen is pressed, the more of the amount is painted</source>
        <translation>ペンを強く押すほど、強くペイントします</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>順序</translation>
    </message>
    <message>
        <source>What you brush over lies in front if this is greater than 0, behind if it is less</source>
        <translation>ブラシでなぞった部分は、0 より大きいと手前、小さいと奥になります</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>辺の長さ</translation>
    </message>
    <message>
        <source>How long the mesh&apos;s edges are where you brush, compared with elsewhere</source>
        <translation>ブラシでなぞった部分のメッシュの辺の長さ（ほかの部分との比）</translation>
    </message>
</context>
<context>
    <name>wend::CheatSheet</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>キーとマウス</translation>
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
        <translation>計算中…</translation>
    </message>
    <message>
        <source>angle %1 · volume %2 · stretch %3</source>
        <translation>角度 %1 · 体積 %2 · 伸び %3</translation>
    </message>
    <message>
        <source>angle %1 · area %2 · stretch %3</source>
        <translation>角度 %1 · 面積 %2 · 伸び %3</translation>
    </message>
    <message>
        <source>The same with another energy</source>
        <translation>別のエネルギーによる同じ形状</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>比較を終了</translation>
    </message>
    <message>
        <source>Shows one shape again.</source>
        <translation>1 つの形状だけの表示に戻します。</translation>
    </message>
    <message>
        <source>What this half keeps, or how it is without paint, with the same pins and motions.</source>
        <translation>こちら側で保つもの、または塗りがない場合の形。ピンと動きは同じです。</translation>
    </message>
    <message>
        <source>Nothing painted</source>
        <translation>塗りなし</translation>
    </message>
</context>
<context>
    <name>wend::CurveActions</name>
    <message>
        <source>&amp;Curve</source>
        <translation>曲線(&amp;C)</translation>
    </message>
    <message>
        <source>Edit &amp;Path</source>
        <translation>パスを編集(&amp;P)</translation>
    </message>
    <message>
        <source>Turn the last path of the selected pin into a Bézier curve</source>
        <translation>選択したピンの最後のパスをベジェ曲線にします</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>&amp;Insert Point</source>
        <translation>ポイントを挿入(&amp;I)</translation>
    </message>
    <message>
        <source>Split the curve at the pointer, or after the chosen point; its shape stays</source>
        <translation>指した位置、または選択したポイントの後ろで曲線を分割します。形は変わりません</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>ポイントを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Remove the chosen point from the curve</source>
        <translation>選択したポイントを曲線から削除します</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>フリー(&amp;F)</translation>
    </message>
    <message>
        <source>Let the two directions at the point be independent</source>
        <translation>ポイントの両側の方向を別々に動かします</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>&amp;Aligned</source>
        <translation>整列(&amp;A)</translation>
    </message>
    <message>
        <source>Keep both directions at the point on one line</source>
        <translation>ポイントの両側の方向を一直線に保ちます</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>自動(&amp;U)</translation>
    </message>
    <message>
        <source>Lead the curve smoothly through the point, guided by its neighbours</source>
        <translation>隣のポイントに合わせて、曲線を滑らかに通します</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>Select one pin that was dragged along a path.</source>
        <translation>パスに沿って動かしたピンを 1 つ選択してください。</translation>
    </message>
    <message>
        <source>Select one pin that follows a curve.</source>
        <translation>曲線に沿って動くピンを 1 つ選択してください。</translation>
    </message>
    <message>
        <source>Click a point of the curve first; two must remain.</source>
        <translation>まず曲線のポイントをクリックしてください。2 つは残す必要があります。</translation>
    </message>
    <message>
        <source>Click an inner point of a Bézier curve first.</source>
        <translation>まずベジェ曲線の途中のポイントをクリックしてください。</translation>
    </message>
</context>
<context>
    <name>wend::CurvePanel</name>
    <message>
        <source>Edit path</source>
        <translation>パスを編集</translation>
    </message>
    <message>
        <source>Turns the drawn path into a Bézier curve with points to drag.</source>
        <translation>描いたパスを、ポイントをドラッグできるベジェ曲線にします。</translation>
    </message>
    <message>
        <source>no</source>
        <translation>しない</translation>
    </message>
    <message>
        <source>as it bends (Frenet)</source>
        <translation>曲率 (Frenet)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>する</translation>
    </message>
    <message>
        <source>Rotate with path</source>
        <translation>パスに沿って回転</translation>
    </message>
    <message>
        <source>Whether what is held turns along the curve, and how.</source>
        <translation>つかんだ部分を曲線に沿って回転させるかどうか、またその方法。</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>ねじれ</translation>
    </message>
    <message>
        <source>How far it turns around the curve&apos;s direction, over the whole curve.</source>
        <translation>曲線全体で、曲線の方向を軸に回転する角度。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>拡大率</translation>
    </message>
    <message>
        <source>How large it has become at the end of the curve.</source>
        <translation>曲線の終点での大きさ。</translation>
    </message>
    <message>
        <source>Rot&amp;ate with path</source>
        <translation>パスに沿って回転(&amp;A)</translation>
    </message>
    <message>
        <source>T&amp;wist</source>
        <translation>ねじれ(&amp;W)</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>拡大率(&amp;C)</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow: hold more vertices.</source>
        <translation>点は回転も拡大もできません。つかむ頂点を増やしてください。</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>曲線を変更</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>イージング</translation>
    </message>
    <message>
        <source>How the motion at the shown time starts and ends.</source>
        <translation>表示中の時刻の動きがどう始まり、どう終わるか。</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>イージングを変更</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow – drag its ring, or give it a radius.</source>
        <translation>点は回転も拡大もできません。リングをドラッグするか、半径を入力してください。</translation>
    </message>
</context>
<context>
    <name>wend::CutOutPanel</name>
    <message>
        <source>Only a cut-out has this. An outline that you have drawn stays as you drew it.</source>
        <translation>これは切り抜きだけの設定です。描いた輪郭は描いたままになります。</translation>
    </message>
</context>
<context>
    <name>wend::CutPanel</name>
    <message>
        <source>Not cut</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Whole cells</source>
        <translation>セル単位</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>正確</translation>
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
        <translation>反転</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>%1 軸に垂直な断面</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>反対側</translation>
    </message>
    <message>
        <source>Turns the plane so that it is perpendicular to this axis.</source>
        <translation>断面をこの軸に垂直にします。</translation>
    </message>
    <message>
        <source>Cuts away the other side of the plane.</source>
        <translation>断面の反対側を取り除きます。</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>断面の位置</translation>
    </message>
    <message>
        <source>Moves the plane through the solid.</source>
        <translation>ソリッドの中で断面を移動します。</translation>
    </message>
    <message>
        <source>Normal of the cut</source>
        <translation>断面の法線</translation>
    </message>
    <message>
        <source>The direction that the plane faces, as x, y and z.</source>
        <translation>断面が向く方向（x、y、z）。</translation>
    </message>
    <message>
        <source>Distance of the cut</source>
        <translation>断面の距離</translation>
    </message>
    <message>
        <source>How far the plane is from the origin, along its normal.</source>
        <translation>法線方向に測った、原点から断面までの距離。</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>&amp;Look inside</source>
        <translation>内部を見る(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>距離(&amp;D)</translation>
    </message>
    <message>
        <source>There is no solid to cut yet.</source>
        <translation>切断できるソリッドがまだありません。</translation>
    </message>
    <message>
        <source>Looks inside: by whole tetrahedra, or along the exact plane.</source>
        <translation>内部を見ます。四面体単位、または正確な平面で切ります。</translation>
    </message>
</context>
<context>
    <name>wend::DepthActions</name>
    <message>
        <source>Bring to &amp;Front</source>
        <translation>最前面へ(&amp;F)</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies in front of all else</source>
        <translation>形状が重なるところで、選択したピンの周囲をほかのすべての手前に置きます</translation>
    </message>
    <message>
        <source>Ctrl+Shift+]</source>
        <translation>Ctrl+Shift+]</translation>
    </message>
    <message>
        <source>Send to &amp;Back</source>
        <translation>最背面へ(&amp;B)</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies behind all else</source>
        <translation>形状が重なるところで、選択したピンの周囲をほかのすべての奥に置きます</translation>
    </message>
    <message>
        <source>Ctrl+Shift+[</source>
        <translation>Ctrl+Shift+[</translation>
    </message>
    <message>
        <source>As &amp;Drawn</source>
        <translation>元の順序(&amp;D)</translation>
    </message>
    <message>
        <source>What is around the selected pins has no order of its own</source>
        <translation>選択したピンの周囲に固有の順序を付けません</translation>
    </message>
    <message>
        <source>&amp;Number…</source>
        <translation>数値(&amp;N)…</translation>
    </message>
    <message>
        <source>Give what is around the selected pins an order: the greater number lies in front</source>
        <translation>選択したピンの周囲に順序を付けます。大きいほど手前になります</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>奥行き(&amp;D)</translation>
    </message>
    <message>
        <source>A solid has depth of its own.</source>
        <translation>ソリッドにはもともと奥行きがあります。</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>まずピンを選択してください。</translation>
    </message>
    <message>
        <source>Bring to front</source>
        <translation>最前面へ</translation>
    </message>
    <message>
        <source>Send to back</source>
        <translation>最背面へ</translation>
    </message>
    <message>
        <source>Depth as drawn</source>
        <translation>奥行きを元の順序に</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>Order (in front: greater than 0, behind: less):</source>
        <translation>順序（0 より大きいと手前、小さいと奥）：</translation>
    </message>
</context>
<context>
    <name>wend::DetailChooser</name>
    <message>
        <source>Choose Skin</source>
        <translation>スキンを選択</translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>サーフェス (%1)</translation>
    </message>
    <message>
        <source>This surface cannot be embedded in the solid. %1</source>
        <translation>このサーフェスはソリッドに追従させることができません。%1</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>スキンを選択</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>スキンを削除</translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Go to the worst place</source>
        <translation>最大ひずみ箇所へ移動</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Colour &amp;by</source>
        <translation>色分け(&amp;B)</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>角度誤差</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation>形状全体での σ₁/σ₂ + σ₂/σ₁ − 2 の総和。すべての角度が保たれていれば 0 です。</translation>
    </message>
    <message>
        <source>Area error</source>
        <translation>面積誤差</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>伸び</translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation>長さが変形前からどれだけ変わったか。剛体運動では 0 です。</translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation>最大ひずみ箇所</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>体積誤差</translation>
    </message>
    <message>
        <source>Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.</source>
        <translation>形状全体での det F + 1/det F − 2 の総和。すべての体積が保たれていれば 0 です。</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation>形状全体での σ₁σ₂ + 1/(σ₁σ₂) − 2 の総和。すべての面積が保たれていれば 0 です。</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>色分け</translation>
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
        <translation>ソリッドを何で色分けするか：長さ、体積、角度の誤差、元の位置からの距離、材質、動く速さ、またはメッシュの細かさ。</translation>
    </message>
    <message>
        <source>What is coloured over the picture: the error of lengths, areas or angles, how far it is from where it was, the material, or how fast it moves.</source>
        <translation>画像を何で色分けするか：長さ、面積、角度の誤差、元の位置からの距離、材質、または動く速さ。</translation>
    </message>
    <message>
        <source>Smooth colo&amp;urs</source>
        <translation>滑らかな色(&amp;U)</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>極端な変形</translation>
    </message>
    <message>
        <source>Passes through itself</source>
        <translation>自己貫通</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>自己交差</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 か所</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n か所</numerusform>
        </translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 セル</translation>
    </message>
    <message numerus="yes">
        <source>%n cells</source>
        <translation>
            <numerusform>%n セル</numerusform>
        </translation>
    </message>
    <message>
        <source>This is checked once the pose is at rest.</source>
        <translation>ポーズが静止してから調べます。</translation>
    </message>
    <message>
        <source>There is no such place.</source>
        <translation>そのような場所はありません。</translation>
    </message>
    <message>
        <source>No place is farther from rest than another.</source>
        <translation>ほかより大きく変わった場所はありません。</translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation>ピン誤差</translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation>最もずれたピンと、本来の位置との距離</translation>
    </message>
    <message>
        <source>Computing time</source>
        <translation>計算時間</translation>
    </message>
    <message>
        <source>How long the shown shape took to compute</source>
        <translation>表示中の形状の計算にかかった時間</translation>
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
        <translation>スケールを固定</translation>
    </message>
    <message>
        <source>How much the overlay covers the picture, or the colours of the solid, below it.</source>
        <translation>オーバーレイが下の画像や立体の色をどれだけ覆うか。</translation>
    </message>
    <message>
        <source>Blends the colours of the overlay from cell to cell. If off, each cell has the one colour of its value.</source>
        <translation>オーバーレイの色をセルからセルへ滑らかに変化させます。オフでは、各セルは値に応じた 1 色です。</translation>
    </message>
    <message>
        <source>Keeps the range of the colours, to compare different shapes and energies.</source>
        <translation>色の範囲を固定し、形状やエネルギーを比べられるようにします。</translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the overlay.</source>
        <translation>最もひずんだ三角形を画面に表示します。オーバーレイでは丸で囲まれます。</translation>
    </message>
    <message>
        <source>The tetrahedron that is farthest from rest in what the overlay shows.</source>
        <translation>オーバーレイの示す量で、変形前から最も離れた四面体。</translation>
    </message>
    <message>
        <source>The triangle that is farthest from rest in what the overlay shows.</source>
        <translation>オーバーレイの示す量で、変形前から最も離れた三角形。</translation>
    </message>
    <message>
        <source>In how many places the surface passes through itself once the pose is at rest, each with its pairs of triangles. A click goes to the next one; the overlay marks them in red.</source>
        <translation>ポーズが静止したときに表面が自分自身を貫く箇所の数です。各箇所は三角形の組からなります。クリックすると次の箇所を表示し、オーバーレイでは赤で示します。</translation>
    </message>
    <message>
        <source>Where the outline crosses itself once the pose is at rest: one part lies over another. A click goes to the next one; the overlay marks them in red.</source>
        <translation>ポーズが静止したときに輪郭が自分自身と交わる箇所です。ある部分が別の部分に重なっています。クリックすると次の箇所を表示し、オーバーレイでは赤で示します。</translation>
    </message>
    <message>
        <source>Tetrahedra with more than ten times their volume, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>体積が 10 倍を超えた、または 10 分の 1 未満になった四面体です。クリックすると次の箇所を表示し、オーバーレイでは赤で示します。</translation>
    </message>
    <message>
        <source>Triangles with more than ten times their area, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>面積が 10 倍を超えた、または 10 分の 1 未満になった三角形です。クリックすると次の箇所を表示し、オーバーレイでは赤で示します。</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>対数</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>色の下限</translation>
    </message>
    <message>
        <source>The value of the first colour. A typed value locks the scale; “≤” in the legend says that some places have less.</source>
        <translation>最初の色の値です。入力した値は尺度を固定します。凡例の「≤」は、それより小さい場所があることを示します。</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>色の上限</translation>
    </message>
    <message>
        <source>The value of the last colour. A typed value locks the scale; “≥” in the legend says that some places have more.</source>
        <translation>最後の色の値です。入力した値は尺度を固定します。凡例の「≥」は、それより大きい場所があることを示します。</translation>
    </message>
    <message>
        <source>Spreads the colours evenly over the orders of magnitude of the values.</source>
        <translation>色を値の桁に均等に割り当てます。</translation>
    </message>
    <message>
        <source>Colours from, to</source>
        <translation>色の範囲</translation>
    </message>
    <message>
        <source>These colours are those of the four energies.</source>
        <translation>これらの色は 4 つのエネルギーの色です。</translation>
    </message>
    <message>
        <source>The scale of this measure is fixed.</source>
        <translation>この尺度の目盛りは固定です。</translation>
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
        <translation>図の大きさ</translation>
    </message>
    <message>
        <source>The drawing becomes a picture of this size. Pins, paths and regions are scaled with it; exported SVG files keep the drawing&apos;s own units.</source>
        <translation>図はこの大きさの画像になります。ピン、パス、領域も拡大縮小されます。書き出す SVG ファイルは図の単位のままです。</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>幅(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高さ(&amp;H)</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>倍率(&amp;S)</translation>
    </message>
    <message>
        <source>Of the size at which the drawing is opened</source>
        <translation>図を開いたときの大きさに対する割合</translation>
    </message>
</context>
<context>
    <name>wend::EaseEditor</name>
    <message>
        <source>Easing Curve</source>
        <translation>イージング曲線</translation>
    </message>
    <message>
        <source>Speed at the &amp;start</source>
        <translation>開始時の速さ(&amp;S)</translation>
    </message>
    <message>
        <source>Speed at the &amp;end</source>
        <translation>終了時の速さ(&amp;E)</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>In percent of the speed of an even move: at 0 % the pin stops there.</source>
        <translation>一定の速さに対する割合。0 % ではそこで止まります。</translation>
    </message>
    <message>
        <source>Speed at the start</source>
        <translation>開始時の速さ</translation>
    </message>
    <message>
        <source>Speed at the end</source>
        <translation>終了時の速さ</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保つ</translation>
    </message>
    <message>
        <source>The pin stays where it was, and goes on from there afterwards.</source>
        <translation>ピンはその場にとどまり、その後そこから動きます。</translation>
    </message>
    <message>
        <source>Choose a bar or a key in the tracks.</source>
        <translation>トラックでバーまたはキーを選んでください。</translation>
    </message>
    <message>
        <source>Rotations and scalings have one of the four easings.</source>
        <translation>回転と拡大縮小は 4 つのイージングのどれかです。</translation>
    </message>
    <message>
        <source>1 motion</source>
        <translation>1 個のモーション</translation>
    </message>
    <message numerus="yes">
        <source>%n motions</source>
        <translation>
            <numerusform>%n 個のモーション</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::EasePlot</name>
    <message>
        <source>Easing curve</source>
        <translation>イージング曲線</translation>
    </message>
    <message>
        <source>How far the pin has come over time. Drag the two handles up or down; Left and Right choose one, Up and Down move it.</source>
        <translation>時間に対してピンが進んだ割合。2 つのハンドルを上下にドラッグ。左右キーで選び、上下キーで動かします。</translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>What the shape keeps where it has to give way: from its volume, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>変形するときに形状が保とうとするもの。体積から、長さ、剛体的な部分、細部の見た目まで。2 つの名前の間では両方の性質を持ちます。</translation>
    </message>
    <message>
        <source>What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>変形するときに形状が保とうとするもの。面積から、長さ、剛体的な部分、細部の見た目まで。2 つの名前の間では両方の性質を持ちます。</translation>
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
        <translation>画像を書き出し</translation>
    </message>
    <message>
        <source>Export Sequence</source>
        <translation>連番を書き出し</translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation>ST マップを書き出し</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>メッシュを書き出し</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>書き出し(&amp;X)…</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>フィルムを書き出す</translation>
    </message>
</context>
<context>
    <name>wend::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>書き出すファイルの種類。</translation>
    </message>
    <message>
        <source>Fit the Can&amp;vas</source>
        <translation>キャンバスを合わせる(&amp;V)</translation>
    </message>
    <message>
        <source>Fit the canvas</source>
        <translation>キャンバスを合わせる</translation>
    </message>
    <message>
        <source>Make the canvas as large as the shape needs, so that nothing is cut off.</source>
        <translation>形状に必要な大きさまでキャンバスを広げ、何も切り取られないようにします。</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>形式(&amp;O)</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>画像と同じ</translation>
    </message>
    <message>
        <source>As it suits the format best</source>
        <translation>形式に応じて最適</translation>
    </message>
    <message>
        <source>%1 px on the left</source>
        <translation>左に %1 px</translation>
    </message>
    <message>
        <source>%1 px at the top</source>
        <translation>上に %1 px</translation>
    </message>
    <message>
        <source>%1 px on the right</source>
        <translation>右に %1 px</translation>
    </message>
    <message>
        <source>%1 px at the bottom</source>
        <translation>下に %1 px</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>As it moves, the shape leaves the picture and is cut off there: %1.</source>
        <translation>途中で形状が画像からはみ出し、切り取られます：%1。</translation>
    </message>
    <message>
        <source>The shape reaches beyond the picture and is cut off there: %1.</source>
        <translation>形状が画像からはみ出し、切り取られます：%1。</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 頂点</translation>
    </message>
    <message numerus="yes">
        <source>%n shapes of %1</source>
        <translation>
            <numerusform>%n 個の形状（各 %1）</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 ピクセル</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures of %1</source>
        <translation>
            <numerusform>%n 枚の画像（各 %1）</numerusform>
        </translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>切り抜き</translation>
    </message>
    <message>
        <source>%1 has no transparency: pictures are placed on white.</source>
        <translation>%1 は透明を持てないため、画像は白の上に置かれます。</translation>
    </message>
</context>
<context>
    <name>wend::ExportPanel</name>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>連番</translation>
    </message>
    <message>
        <source>ST Map</source>
        <translation>STマップ</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Choose a name and write what the preview shows.</source>
        <translation>名前を選び、プレビューに見えるものを書き出します。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>フィルム</translation>
    </message>
</context>
<context>
    <name>wend::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>What will be written, smaller</source>
        <translation>書き出される内容の縮小表示</translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>Writing the picture …</source>
        <translation>画像を書き出しています…</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n frames …</source>
        <translation>
            <numerusform>%n フレームを書き出しています…</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation>メッシュを書き出しています…</translation>
    </message>
    <message>
        <source>“%1” is this project itself. Replace it?</source>
        <translation>「%1」はこのプロジェクトそのものです。置き換えますか？</translation>
    </message>
    <message>
        <source>“%1” is the picture that this project bends. Replace it?</source>
        <translation>「%1」はこのプロジェクトで変形している画像です。置き換えますか？</translation>
    </message>
    <message>
        <source>“%1” is the mesh that this project bends. Replace it?</source>
        <translation>「%1」はこのプロジェクトで変形しているメッシュです。置き換えますか？</translation>
    </message>
    <message>
        <source>“%1” belongs to this project. Replace it?</source>
        <translation>「%1」はこのプロジェクトの一部です。置き換えますか？</translation>
    </message>
    <message>
        <source>Another export is still being written. Try again in a moment.</source>
        <translation>別の書き出しがまだ終わっていません。しばらくしてからもう一度お試しください。</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>形状をまだ計算しています。しばらくしてからもう一度お試しください。</translation>
    </message>
    <message>
        <source>There is no shape to export: it could not be computed.</source>
        <translation>書き出す形状がありません。計算できませんでした。</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message numerus="yes">
        <source>Replace the frames that already exist (%n)?</source>
        <translation>
            <numerusform>このうち %n フレームはすでに存在します。置き換えますか？</numerusform>
        </translation>
    </message>
    <message>
        <source>What it holds now will be lost, and the project will no longer open as it is.</source>
        <translation>現在の内容は失われ、プロジェクトは今のようには開けなくなります。</translation>
    </message>
    <message>
        <source>What they hold now will be lost.</source>
        <translation>現在の内容は失われます。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>何も書き出されませんでした。%1</translation>
    </message>
    <message>
        <source>Written without velocities: %1 (%2)</source>
        <translation>速度なしで書き出しました：%1（%2）</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
    <message>
        <source>Export Material</source>
        <translation>材質を書き出し</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>画像 (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Writing the ST map …</source>
        <translation>ST マップを書き出しています…</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>フィルムを書き出しています…</translation>
    </message>
</context>
<context>
    <name>wend::FactsPanel</name>
    <message>
        <source>size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>辺</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ~ %2</translation>
    </message>
    <message>
        <source>mean edge</source>
        <translation>平均の辺</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>boundary loops</source>
        <translation>境界ループ</translation>
    </message>
    <message>
        <source>genus</source>
        <translation>種数</translation>
    </message>
    <message>
        <source>crossing pairs</source>
        <translation>交差する組</translation>
    </message>
    <message>
        <source>Worst cell</source>
        <translation>最悪のセル</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>次の隙間</translation>
    </message>
    <message>
        <source>Open the widest</source>
        <translation>最も広い隙間を開く</translation>
    </message>
    <message>
        <source>Facts of the file</source>
        <translation>ファイルの諸元</translation>
    </message>
    <message>
        <source>The surface as it is in its file. Lengths are in the file&apos;s units, which few files name.</source>
        <translation>ファイルにあるままの表面。長さはファイルの単位ですが、単位を記すファイルはわずかです。</translation>
    </message>
    <message>
        <source>Quality of the cells</source>
        <translation>セルの品質</translation>
    </message>
    <message>
        <source>Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are above that, and how many triangles of the surface force them.</source>
        <translation>最悪の四面体の外接球半径と最短辺の比、求めた値、それを超える数、それを強いる表面の三角形の数。</translation>
    </message>
    <message>
        <source>Closed gaps</source>
        <translation>閉じられた隙間</translation>
    </message>
    <message>
        <source>Gaps within one part that the cage closes: what lies on both sides moves together.</source>
        <translation>ケージが閉じる、一つの部分の中の隙間。両側は一緒に動きます。</translation>
    </message>
    <message>
        <source>Goes to the tetrahedron with the largest ratio.</source>
        <translation>比が最大の四面体を表示します。</translation>
    </message>
    <message>
        <source>Goes through the gaps that the cage closes, one after another.</source>
        <translation>ケージが閉じる隙間を順に表示します。</translation>
    </message>
    <message>
        <source>Makes the cage so fine that the widest of these gaps stays open.</source>
        <translation>最も広い隙間が開いたままになるまでケージを細かくします。</translation>
    </message>
    <message>
        <source>Looking at the file …</source>
        <translation>ファイルを調べています…</translation>
    </message>
    <message>
        <source>Surface of the file</source>
        <translation>ファイルの表面</translation>
    </message>
    <message>
        <source>worst ratio</source>
        <translation>最悪の比</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>求めた値</translation>
    </message>
    <message>
        <source>cells above</source>
        <translation>超えるセル</translation>
    </message>
    <message>
        <source>forced by triangles</source>
        <translation>強いる三角形</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>四面体</translation>
    </message>
    <message>
        <source>That would take more than a million vertices.</source>
        <translation>百万を超える頂点が必要です。</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>ケージ</translation>
    </message>
    <message>
        <source>closed gaps</source>
        <translation>閉じた隙間</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>最も狭い</translation>
    </message>
    <message>
        <source>Open a gap</source>
        <translation>隙間を開く</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>面の側</translation>
    </message>
</context>
<context>
    <name>wend::FileCard</name>
    <message>
        <source>Sample: %1</source>
        <translation>サンプル：%1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 を開く</translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation>サンプル「%1」を開く</translation>
    </message>
    <message>
        <source>%1, solid</source>
        <translation>%1（ソリッド）</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>ソリッド</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>%1 を復元</translation>
    </message>
    <message>
        <source>Open the unsaved changes to “%1”</source>
        <translation>「%1」の保存されていない変更を開きます</translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation>Wend で開けるすべてのファイル (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>プロジェクト (*.wend)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>メッシュ (%1)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>%1 has moved.</source>
        <translation>%1 が元の場所にありません。</translation>
    </message>
    <message>
        <source>Find It…</source>
        <translation>場所を指定…</translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation>このファイルは開けません。%1</translation>
    </message>
    <message>
        <source>Nothing to see in this picture.</source>
        <translation>この画像には見える部分がありません。</translation>
    </message>
    <message>
        <source>Use Whole Frame</source>
        <translation>画像全体を使う</translation>
    </message>
    <message>
        <source>Open Another…</source>
        <translation>別のファイルを開く…</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>すべてのファイル</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 の場所を指定</translation>
    </message>
    <message>
        <source>Your changes cannot be recovered if the program crashes: please save. %1</source>
        <translation>プログラムがクラッシュした場合、変更内容のコピーは残りません。保存してください。%1</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>“%1” was changed by another program or window.</source>
        <translation>「%1」は別のプログラムまたはウィンドウで変更されました。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>自分の変更を残す</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>別名で保存…</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>「%1」を再読み込みしますか？</translation>
    </message>
    <message>
        <source>Your changes since it was saved will be lost.</source>
        <translation>保存後に行った変更は失われます。</translation>
    </message>
    <message>
        <source>Saving replaces those changes; reloading discards yours.</source>
        <translation>保存するとその変更が置き換えられ、再読み込みすると自分の変更が失われます。</translation>
    </message>
    <message>
        <source>The project was not saved: it needs the file “%1” itself. Choose another name.</source>
        <translation>プロジェクトは保存されませんでした。ファイル「%1」そのものが必要です。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation>プロジェクトは保存されませんでした。%1</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>「%1」への変更を保存しますか？</translation>
    </message>
    <message>
        <source>If you do not save, they will be lost.</source>
        <translation>保存しない場合、変更は失われます。</translation>
    </message>
    <message>
        <source>Wend was not closed properly: there are unsaved changes to “%1”.</source>
        <translation>Wend は正しく終了しませんでした。「%1」に保存されていない変更があります。</translation>
    </message>
    <message>
        <source>Discard the unsaved changes to “%1”? They cannot be brought back.</source>
        <translation>「%1」の保存されていない変更を破棄しますか？ 元には戻せません。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save what you made of “%1”?</source>
        <translation>「%1」から作ったものを保存しますか？</translation>
    </message>
    <message>
        <source>It becomes a project of its own; the file stays as it is. If you do not save, what you made will be lost.</source>
        <translation>別のプロジェクトとして保存され、元のファイルは変わりません。保存しない場合、作ったものは失われます。</translation>
    </message>
    <message>
        <source>“%1” %2.</source>
        <comment>a file, and what is wrong with it</comment>
        <translation>「%1」%2。</translation>
    </message>
    <message>
        <source>Pictures with layers (%1)</source>
        <translation>レイヤーのある画像 (%1)</translation>
    </message>
</context>
<context>
    <name>wend::FilmPanel</name>
    <message>
        <source>Cycle</source>
        <translation>サイクル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>取り除く</translation>
    </message>
    <message>
        <source>Choose sound</source>
        <translation>音声を選択</translation>
    </message>
    <message>
        <source>A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films.</source>
        <translation>動きと同時に始まる音声のファイル。MP4、WebM、QuickTime のフィルムに入ります。</translation>
    </message>
    <message>
        <source>Remove sound</source>
        <translation>音声を取り除く</translation>
    </message>
    <message>
        <source>The film has no sound then.</source>
        <translation>フィルムは無音になります。</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>フィルム</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音声</translation>
    </message>
    <message>
        <source>The part of the film that repeats, in seconds. A film that is exported as a loop shows it, and no picture twice.</source>
        <translation>繰り返される部分（秒）。ループとして書き出したフィルムはこの部分を、同じ画像を重ねずに表示します。</translation>
    </message>
    <message>
        <source>from</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終了</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>サイクルを変更</translation>
    </message>
    <message>
        <source>Choose Sound</source>
        <translation>音声を選択</translation>
    </message>
    <message>
        <source>Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</source>
        <translation>音声とフィルム (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</translation>
    </message>
</context>
<context>
    <name>wend::FlowPanel</name>
    <message>
        <source>Relax</source>
        <translation>緩める</translation>
    </message>
    <message>
        <source>The pins stay where they are, and what lies between them releases its tension. This takes one second at the end of the film.</source>
        <translation>ピンの位置はそのままで、その間の部分の張りを緩めます。フィルムの最後に 1 秒かかります。</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>元の形に戻る力</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>まだ何も動いていません。</translation>
    </message>
    <message>
        <source>A shape that springs back fully is always relaxed.</source>
        <translation>完全に元へ戻る形は常に緩んでいます。</translation>
    </message>
</context>
<context>
    <name>wend::GroupList</name>
    <message>
        <source>Hold It</source>
        <translation>固定する</translation>
    </message>
    <message>
        <source>Groups of the file</source>
        <translation>ファイルのグループ</translation>
    </message>
    <message>
        <source>What the mesh&apos;s file calls by a name or number. A click marks a group on the shape; a double click, or Enter, pins it.</source>
        <translation>メッシュのファイルが名前や番号で呼ぶもの。クリックで形の上に示し、ダブルクリックまたは Enter でピン留めします。</translation>
    </message>
    <message>
        <source>Hold the group</source>
        <translation>グループを固定</translation>
    </message>
    <message>
        <source>Makes a pin of the chosen group, which the project names, so that it fits other meshes, too.</source>
        <translation>選んだグループをピンにします。プロジェクトはその名前を記録するので、他のメッシュにも使えます。</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>線</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>%1 (%2 %3)</source>
        <comment>name, number and kind of cells</comment>
        <translation>%1(%3 %2)</translation>
    </message>
</context>
<context>
    <name>wend::HandlePanel</name>
    <message>
        <source>Select a pin to see its numbers.</source>
        <translation>ピンを選択すると数値が表示されます。</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>拡大・縮小</translation>
    </message>
    <message>
        <source>Exact step</source>
        <translation>数値による変形</translation>
    </message>
    <message>
        <source>Moves, rotates or scales what is selected by exact numbers.</source>
        <translation>選択したものを正確な数値で移動、回転、拡大・縮小します。</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>値</translation>
    </message>
    <message>
        <source>How far along x, y and z; an angle; or a factor.</source>
        <translation>x、y、z 方向の距離、角度、または倍率。</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>X 軸まわり</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>Y 軸まわり</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>Z 軸まわり</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>The axis of the rotation, through the middle of what is selected.</source>
        <translation>選択したものの中心を通る回転軸。</translation>
    </message>
    <message>
        <source>Applies this step; it becomes part of the motion.</source>
        <translation>この操作を実行し、モーションに加えます。</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>at %1, %2, %3</source>
        <translation>位置 %1, %2, %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>位置 %1, %2</translation>
    </message>
    <message>
        <source>does not hold now</source>
        <translation>今は固定していません</translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>wend::KeyPoseStrip</name>
    <message>
        <source>Key poses</source>
        <translation>キーポーズ</translation>
    </message>
    <message>
        <source>The shape at the key poses of all pins: a click goes there</source>
        <translation>すべてのピンのキーポーズでの形。クリックでそこへ移動</translation>
    </message>
    <message>
        <source>Key pose at %1</source>
        <translation>キーポーズ：%1</translation>
    </message>
</context>
<context>
    <name>wend::LanguageChoice</name>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>デスクトップに合わせる(&amp;D)</translation>
    </message>
    <message>
        <source>Speak the desktop&apos;s language, if Wend knows it</source>
        <translation>Wend が対応していれば、デスクトップの言語で表示します</translation>
    </message>
    <message>
        <source>Speak %1</source>
        <translation>%1 で表示します</translation>
    </message>
    <message>
        <source>The language of the window, from the next start of Wend</source>
        <translation>ウィンドウの言語。次回の起動から有効になります</translation>
    </message>
    <message>
        <source>The language changes when Wend starts the next time.</source>
        <translation>言語は、次回 Wend を起動したときに変わります。</translation>
    </message>
</context>
<context>
    <name>wend::LayerPanel</name>
    <message>
        <source>The material is the same everywhere: brush over the shape to change a part.</source>
        <translation>全体が同じ材質です。一部を変えるには形状をブラシでなぞってください。</translation>
    </message>
    <message>
        <source>Each along a direction of its own.</source>
        <translation>それぞれ固有の方向を持ちます。</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Lets the chosen layer win over the one above it.</source>
        <translation>選択したレイヤーを 1 つ上のレイヤーより優先します。</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Lets the layer below win over the chosen one.</source>
        <translation>1 つ下のレイヤーを選択したレイヤーより優先します。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Removes the chosen layer.</source>
        <translation>選択したレイヤーを削除します。</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>How many times stiffer the layer is along its direction; ×1 is the same as everywhere.</source>
        <translation>レイヤーの方向に沿って何倍の剛性にするか。×1 はほかと同じです。</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>剛性の方向</translation>
    </message>
    <message>
        <source>At rest; it turns with the shape. A change is for all regions of the layer.</source>
        <translation>変形前の方向で、形状とともに回転します。変更するとレイヤーのすべての領域に適用されます。</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>境界のぼかし</translation>
    </message>
    <message>
        <source>How wide the edge fades, in the shape&apos;s own units.</source>
        <translation>境界をぼかす幅（形状の単位）。</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>境界のぼかし(&amp;G)</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>レイヤー名を変更</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>レイヤーを移動</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>レイヤーを削除</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>境界のぼかしを変更</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>レイヤーを変更</translation>
    </message>
    <message>
        <source>Unnamed</source>
        <translation>名称未設定</translation>
    </message>
    <message>
        <source>Where the material differs. The topmost layer wins; drag a layer to move it. A click shows its values, a double-click changes its name, its eye or the space bar switches it off.</source>
        <translation>材質が異なる部分。いちばん上のレイヤーが優先されます。レイヤーはドラッグで並べ替えられます。クリックで値を表示、ダブルクリックで名前を変更、目のアイコンまたはスペースキーでオフにします。</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Imports the material from pictures made in a paint program, and exports it as such.</source>
        <translation>材質をペイントソフトの画像から読み込み、また画像として書き出します。</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Takes the pictures as they are now, after they have been saved in a paint program.</source>
        <translation>ペイントソフトで保存された後の、現在の画像を読み込みます。</translation>
    </message>
    <message>
        <source>Read pictures again</source>
        <translation>画像を再読み込み</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>レイヤーを隠す</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>レイヤーを表示</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>保持：%1</translation>
    </message>
    <message>
        <source>Stiffness: %1</source>
        <translation>剛性：%1</translation>
    </message>
    <message>
        <source>Direction: %1</source>
        <translation>方向：%1</translation>
    </message>
    <message>
        <source>As the project&apos;s file says, cell by cell.</source>
        <translation>プロジェクトファイルの値のとおり、セルごと。</translation>
    </message>
    <message>
        <source>Cell by cell: %1</source>
        <translation>セルごと：%1</translation>
    </message>
    <message>
        <source>Values of cells</source>
        <translation>セルの値</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>下のレイヤーと結合(&amp;M)</translation>
    </message>
    <message>
        <source>Makes one layer of the chosen one and the one below it</source>
        <translation>選んだレイヤーとその下のレイヤーを 1 つにします</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>レイヤーを結合</translation>
    </message>
    <message>
        <source>Stiffness ×1 has no direction: first choose how many times stiffer it is.</source>
        <translation>剛性 ×1 には方向がありません。まず何倍の剛性かを選んでください。</translation>
    </message>
    <message>
        <source>What a file gives cell by cell stays lowest.</source>
        <translation>セルごとの値のファイルは常に一番下です。</translation>
    </message>
    <message>
        <source>This is already the lowest layer.</source>
        <translation>すでに一番下のレイヤーです。</translation>
    </message>
    <message>
        <source>This is already the topmost layer.</source>
        <translation>すでに一番上のレイヤーです。</translation>
    </message>
    <message>
        <source>One of the two is switched off, is a picture, or erases.</source>
        <translation>どちらかが無効、画像、または消去のレイヤーです。</translation>
    </message>
    <message>
        <source>There is no layer below it.</source>
        <translation>下にレイヤーがありません。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前を変更(&amp;N)</translation>
    </message>
    <message>
        <source>What a file says of each cell has no name.</source>
        <translation>ファイルがセルごとに定めるものに名前はありません。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Whether the layer changes Keep, and to what.</source>
        <translation>レイヤーが「保持」を変えるかどうかと、その内容。</translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation>凡例</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1：%2 ～ %3</translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>メイン</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation>%1[*] – Wend</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Let go to open “%1”</source>
        <translation>離すと「%1」を開きます</translation>
    </message>
    <message numerus="yes">
        <source>Let go to open %n pictures as parts</source>
        <translation>
            <numerusform>離すと %n 枚の画像をパーツとして開きます</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>The first page</source>
        <translation>最初のページ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>The previous page</source>
        <translation>前に見たページ</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>どのページにもありません。</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>マニュアルを検索</translation>
    </message>
    <message>
        <source>Enter goes to the next place with these words, on this page or another.</source>
        <translation>Enter で、このページまたは別のページにある次の箇所へ移ります。</translation>
    </message>
</context>
<context>
    <name>wend::MaterialActions</name>
    <message>
        <source>A grey picture over the whole, as a layer: black keeps area, white keeps angles</source>
        <translation>全体を覆うグレー画像をレイヤーとして読み込みます。黒は面積、白は角度を保ちます</translation>
    </message>
    <message>
        <source>Import &amp;Stiffness…</source>
        <translation>剛性を読み込む(&amp;S)…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer: black is the same as everywhere, white is 1000 times stiffer</source>
        <translation>全体を覆うグレー画像をレイヤーとして読み込みます。黒はほかと同じ、白は 1000 倍の剛性です</translation>
    </message>
    <message>
        <source>Import &amp;Directions…</source>
        <translation>方向を読み込む(&amp;D)…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer, of the direction of stiffness: black is level, middle grey upright</source>
        <translation>全体を覆うグレー画像をレイヤーとして読み込みます。黒は水平、中間のグレーは垂直で、剛性はその方向に働きます</translation>
    </message>
    <message>
        <source>Import Values of &amp;Cells…</source>
        <translation>セルの値を読み込む(&amp;C)…</translation>
    </message>
    <message>
        <source>φ and B of every cell from a mesh file that contains them, such as an exported one</source>
        <translation>書き出したメッシュなど、各セルの φ と B を含むメッシュファイルから読み込みます</translation>
    </message>
    <message>
        <source>As a grey picture, to be edited in a paint program</source>
        <translation>ペイントソフトで続きを描けるよう、グレー画像として書き出します</translation>
    </message>
    <message>
        <source>Export S&amp;tiffness…</source>
        <translation>剛性を書き出す(&amp;T)…</translation>
    </message>
    <message>
        <source>Export Di&amp;rections…</source>
        <translation>方向を書き出す(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>材質(&amp;M)</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>まず画像を開いてください。</translation>
    </message>
    <message>
        <source>For a solid, these are values of cells; they are exported with its mesh.</source>
        <translation>ソリッドではセルの値になり、メッシュとともに書き出されます。</translation>
    </message>
    <message>
        <source>Only the cells of a mesh file stay the same.</source>
        <translation>同じセルのまま変わらないのは、メッシュファイルのセルだけです。</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 を読み込み</translation>
    </message>
    <message>
        <source>Values of cells (*.vtu *.vtk *.json)</source>
        <translation>セルの値 (*.vtu *.vtk *.json)</translation>
    </message>
    <message>
        <source>The layers were switched off: what was imported lies below them.</source>
        <translation>レイヤーをオフにしました。読み込んだ値はレイヤーの下にあります。</translation>
    </message>
    <message>
        <source>Import &amp;Keep…</source>
        <translation>「保持」を読み込む(&amp;K)…</translation>
    </message>
    <message>
        <source>Export K&amp;eep…</source>
        <translation>「保持」を書き出す(&amp;E)…</translation>
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
        <translation>%1と%2の中間です。</translation>
    </message>
    <message>
        <source>Grown ×%1 – try %2</source>
        <translation>×%1 に拡大 – %2を試す</translation>
    </message>
    <message>
        <source>The shape has become much larger than at rest. A click keeps more of its size.</source>
        <translation>形状が変形前よりかなり大きくなりました。クリックすると大きさをより保つようにします。</translation>
    </message>
    <message>
        <source>Whole shape</source>
        <translation>形全体</translation>
    </message>
    <message>
        <source>Keep: whole shape</source>
        <translation>保持：形全体</translation>
    </message>
</context>
<context>
    <name>wend::MeasurePanel</name>
    <message>
        <source>Measures</source>
        <translation>計測値</translation>
    </message>
    <message>
        <source>Size of the solid</source>
        <translation>ソリッドのサイズ</translation>
    </message>
    <message>
        <source>Volume and area of the surface, now and at rest.</source>
        <translation>体積と表面積（現在と変形前）。</translation>
    </message>
    <message>
        <source>Size of what is selected</source>
        <translation>選択範囲のサイズ</translation>
    </message>
    <message>
        <source>Volume of the tetrahedra and area of the outer triangles that the selected handles hold.</source>
        <translation>選択したハンドルがつかむ四面体の体積と、外側の三角形の面積。</translation>
    </message>
    <message>
        <source>Vertex under the pointer</source>
        <translation>ポインター下の頂点</translation>
    </message>
    <message>
        <source>The nearest vertex and where it is.</source>
        <translation>最も近い頂点とその位置。</translation>
    </message>
    <message>
        <source>Tetrahedron under the pointer</source>
        <translation>ポインター下の四面体</translation>
    </message>
    <message>
        <source>All values of the tetrahedron.</source>
        <translation>四面体のすべての値。</translation>
    </message>
    <message>
        <source>%1, at rest %2</source>
        <translation>%1（変形前 %2）</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>The whole</source>
        <translation>全体</translation>
    </message>
    <message numerus="yes">
        <source>Selected vertices: %n</source>
        <translation>
            <numerusform>選択範囲：頂点 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Point at the solid to see the values there.</source>
        <translation>ソリッドにポインターを合わせると、そこの値が表示されます。</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>頂点 %1</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>変形前</translation>
    </message>
    <message>
        <source>pointed at</source>
        <translation>ポインター</translation>
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
        <translation>%1 ～ %2</translation>
    </message>
    <message>
        <source>circumradius to shortest edge</source>
        <translation>外接球半径 / 最短辺</translation>
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
        <translation>なし</translation>
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
        <translation>頂点数</translation>
    </message>
    <message>
        <source>Maximum volume</source>
        <translation>最大体積</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>What sets how fine the mesh is: how many vertices it has in total, or how large a tetrahedron may be.</source>
        <translation>メッシュの細かさの決め方：全体の頂点数、または四面体の最大の大きさ。</translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>ペイント…</translation>
    </message>
    <message>
        <source>Cell sizes</source>
        <translation>セルサイズ</translation>
    </message>
    <message>
        <source>Paints where the mesh should be finer or coarser, or sets it by regions in numbers.</source>
        <translation>メッシュを細かくする、または粗くする場所をペイントするか、領域の数値で指定します。</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>A&amp;im at</source>
        <translation>目標(&amp;I)</translation>
    </message>
    <message>
        <source>Detail: coarse – fine</source>
        <translation>細かさ：粗い – 細かい</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>細かく・粗く</translation>
    </message>
    <message>
        <source>Aim at a volume</source>
        <translation>体積を目標に</translation>
    </message>
    <message>
        <source>Aim at vertices</source>
        <translation>頂点数を目標に</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>メッシュはファイルから読み込まれ、そのまま使われます。</translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation>この画像には透明な部分がありません。</translation>
    </message>
    <message>
        <source>No outline has been drawn.</source>
        <translation>輪郭が描かれていません。</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>頂点 %1、四面体 %2</translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation>頂点 %1、三角形 %2</translation>
    </message>
    <message>
        <source>Outline and detail of</source>
        <translation>輪郭と細かさの対象</translation>
    </message>
    <message>
        <source>Which part of the picture has the outline and detail below; all have the same unless one has its own. Choosing a part in the list of parts chooses it here.</source>
        <translation>下の輪郭と細かさを持つパーツ。独自のものがなければ、すべて同じです。パーツのリストで選ぶと、ここでも選ばれます。</translation>
    </message>
    <message>
        <source>As All Parts</source>
        <translation>すべてのパーツと同じ</translation>
    </message>
    <message>
        <source>Gives this part the outline and detail of all parts again.</source>
        <translation>このパーツの輪郭と細かさを、すべてのパーツと同じに戻します。</translation>
    </message>
    <message>
        <source>&amp;Of</source>
        <translation>対象(&amp;F)</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>すべてのパーツ</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>スキンを選択</translation>
    </message>
    <message>
        <source>Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view shows it, and surface formats contain it.</source>
        <translation>テクスチャ付きも可能な精細なサーフェスをファイルから読み込みます。ソリッドに追従し、ビューに表示され、サーフェス形式で書き出されます。</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>スキンを削除</translation>
    </message>
    <message>
        <source>Shows and exports the solid with its own surface again.</source>
        <translation>ソリッドの表示と書き出しを、元のサーフェスに戻します。</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>スキン</translation>
    </message>
</context>
<context>
    <name>wend::ModeRow</name>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>How large the picture is shown; a click shows its pixels as they are.</source>
        <translation>画像の表示倍率。クリックすると等倍で表示します。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Export what is shown as a picture, film, sequence, ST map, mesh or view</source>
        <translation>表示中のものを、画像、フィルム、連番、ST マップ、メッシュ、ビューとして書き出します</translation>
    </message>
</context>
<context>
    <name>wend::MotionChooser</name>
    <message>
        <source>Apply Motion of Another Project</source>
        <translation>他のプロジェクトの動きを適用</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>プロジェクト (*.wend)</translation>
    </message>
    <message>
        <source>This motion cannot be applied. %1</source>
        <translation>この動きは適用できません。%1</translation>
    </message>
    <message>
        <source>Apply motion of %1</source>
        <translation>%1 の動きを適用</translation>
    </message>
</context>
<context>
    <name>wend::Offers</name>
    <message>
        <source>This picture fills its frame. If its border is held, it bends inside and no gap opens at the edges.</source>
        <translation>この画像は枠いっぱいに描かれています。端を固定すると、内側だけが変形し、縁にすき間ができません。</translation>
    </message>
    <message>
        <source>Hold the Border</source>
        <translation>画像の端を固定</translation>
    </message>
    <message>
        <source>Soft edges or shadows of this picture reach beyond the cut-out, and are cut off.</source>
        <translation>この画像の柔らかい縁や影が切り抜きの外に広がっていて、切り落とされます。</translation>
    </message>
    <message>
        <source>Include Them</source>
        <translation>含める</translation>
    </message>
    <message>
        <source>This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they enclose, too.</source>
        <translation>この画像はほとんどが細い線で、線だけが曲がります。穴を埋めると、線で囲まれた内側も曲がります。</translation>
    </message>
    <message>
        <source>Fill the Holes</source>
        <translation>穴を埋める</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n 枚の画像をパーツとして開きました。それぞれ単独で曲がります。接するところで「パーツ」から接合してください。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layers were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n 枚のレイヤーをパーツとして開きました。それぞれ単独で曲がります。接するところで「パーツ」から接合してください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Open Flattened</source>
        <translation>統合して開く</translation>
    </message>
    <message>
        <source>Open flattened</source>
        <translation>統合して開く</translation>
    </message>
    <message>
        <source>Another Size…</source>
        <translation>別の大きさ…</translation>
    </message>
    <message>
        <source>This drawing became a picture of %1 × %2 pixels.</source>
        <translation>この図は %1 × %2 ピクセルの画像になりました。</translation>
    </message>
</context>
<context>
    <name>wend::OpeningNote</name>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 を開いています…</translation>
    </message>
</context>
<context>
    <name>wend::OptionRow</name>
    <message>
        <source>Options</source>
        <translation>オプション</translation>
    </message>
</context>
<context>
    <name>wend::PaintPanel</name>
    <message>
        <source>How many times stiffer the painted part is along its direction; ×1 is the same as everywhere.</source>
        <translation>ペイントした部分を、その方向に沿って何倍の剛性にするか。×1 はほかと同じです。</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>剛性の方向</translation>
    </message>
    <message>
        <source>The direction at rest, which turns with the shape: the stroke&apos;s own, the one that is there, an axis, numbers, or the path of the selected pin where it is nearest.</source>
        <translation>形状とともに回転する、変形前の方向：ストロークの方向、今ある方向、軸、数値、または選択したピンのパスの最も近い部分の方向。</translation>
    </message>
    <message>
        <source>Direction in numbers</source>
        <translation>数値による方向</translation>
    </message>
    <message>
        <source>At rest; its length does not matter.</source>
        <translation>変形前の方向です。長さは関係ありません。</translation>
    </message>
    <message>
        <source>St&amp;iffness</source>
        <translation>剛性(&amp;I)</translation>
    </message>
    <message>
        <source>Di&amp;rection</source>
        <translation>方向(&amp;R)</translation>
    </message>
    <message>
        <source>along the stroke</source>
        <translation>ストロークに沿う</translation>
    </message>
    <message>
        <source>as it is there</source>
        <translation>今の方向のまま</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>X 軸に沿う</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>Y 軸に沿う</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>Z 軸に沿う</translation>
    </message>
    <message>
        <source>as numbers</source>
        <translation>数値で指定</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>視線に沿う</translation>
    </message>
    <message>
        <source>along the pin&apos;s path</source>
        <translation>ピンのパスに沿う</translation>
    </message>
    <message>
        <source>What the brush paints</source>
        <translation>ブラシで塗るもの</translation>
    </message>
    <message>
        <source>The brush paints</source>
        <translation>ブラシで塗る</translation>
    </message>
</context>
<context>
    <name>wend::PartList</name>
    <message>
        <source>Joint x</source>
        <translation>関節 x</translation>
    </message>
    <message>
        <source>Joint y</source>
        <translation>関節 y</translation>
    </message>
    <message>
        <source>Move joint</source>
        <translation>関節を移動</translation>
    </message>
    <message>
        <source>Where the part turns at rest, in pixels from the upper left corner: a point in both parts, marked by a ring on the picture.</source>
        <translation>静止時にパーツが回転する位置（左上からのピクセル）。両方のパーツに含まれる点で、画像上に輪で示されます。</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>非表示</translation>
    </message>
    <message>
        <source>rides on %1</source>
        <translation>%1 に追従</translation>
    </message>
    <message>
        <source>joined to %1</source>
        <translation>%1 に接合</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Opac&amp;ity</source>
        <translation>不透明度(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Joined to</source>
        <translation>接合先(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Rides on</source>
        <translation>追従先(&amp;R)</translation>
    </message>
    <message>
        <source>Parts of the picture</source>
        <translation>画像のパーツ</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前面へ</translation>
    </message>
    <message>
        <source>Brings the part in front of the next one (Alt+Up).</source>
        <translation>パーツを次のパーツの前に出します (Alt+↑)。</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>背面へ</translation>
    </message>
    <message>
        <source>Brings the part behind the next one (Alt+Down).</source>
        <translation>パーツを次のパーツの後ろに下げます (Alt+↓)。</translation>
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
        <translation>パーツの見える度合い。</translation>
    </message>
    <message>
        <source>Joined to</source>
        <translation>接合先</translation>
    </message>
    <message>
        <source>Welds the part to another one in the middle of where they overlap at rest: it turns there, and pulls nothing else.</source>
        <translation>静止時に重なる部分の中央で別のパーツに接合します。そこで回転し、ほかは引っ張りません。</translation>
    </message>
    <message>
        <source>Rides on</source>
        <translation>追従先</translation>
    </message>
    <message>
        <source>The part follows the motion of another one, as eyes do on a face.</source>
        <translation>顔の目のように、別のパーツの動きに追従します。</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>不透明度を変更</translation>
    </message>
    <message>
        <source>Choose a part that is not in front.</source>
        <translation>最前面でないパーツを選んでください。</translation>
    </message>
    <message>
        <source>Choose a part that is not at the back.</source>
        <translation>最背面でないパーツを選んでください。</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>パーツを隠す</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>パーツを表示</translation>
    </message>
    <message>
        <source>Another part has this name.</source>
        <translation>別のパーツがこの名前です。</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>パーツの名前を変更</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>順序を変更</translation>
    </message>
    <message>
        <source>These parts do not overlap at rest: there is no place for a joint.</source>
        <translation>これらのパーツは静止時に重ならず、関節を置く場所がありません。</translation>
    </message>
    <message>
        <source>Remove joint</source>
        <translation>関節を取り除く</translation>
    </message>
    <message>
        <source>Join parts</source>
        <translation>パーツを接合</translation>
    </message>
    <message>
        <source>Change what a part rides on</source>
        <translation>パーツの追従先を変更</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>乗算</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>スクリーン</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>加算</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>&amp;Blend mode</source>
        <translation>描画モード(&amp;B)</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>描画モード</translation>
    </message>
    <message>
        <source>How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen and Add lighten, as light does.</source>
        <translation>パーツを下にあるものとどう合成するか。乗算は影のように暗くし、スクリーンと加算は光のように明るくします。</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>描画モードを変更</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>柔らかい縁(&amp;F)</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>柔らかい縁</translation>
    </message>
    <message>
        <source>How wide the edge is along which the part was cut out. The colours of what is behind it are removed from it.</source>
        <translation>パーツを切り抜いた縁の幅。後ろにあるものの色は取り除かれます。</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>柔らかい縁を変更</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies in front; click its eye to hide it; the lock at its end protects it from changes; a double-click changes its name.</source>
        <translation>いちばん手前のパーツが先頭です。ドラッグするか Alt と矢印キーで順序を変えます。目をクリックすると隠れ、右端の錠で変更から保護し、ダブルクリックで名前を変えます。</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>The part is seen, but clicks go through it, and it is neither painted nor are its pins moved.</source>
        <translation>パーツは表示されますが、クリックは下に通り、塗られず、ピンも動きません。</translation>
    </message>
    <message>
        <source>Choose a part.</source>
        <translation>パーツを選んでください。</translation>
    </message>
    <message>
        <source>Lock part</source>
        <translation>パーツをロック</translation>
    </message>
    <message>
        <source>Unlock part</source>
        <translation>パーツのロックを解除</translation>
    </message>
</context>
<context>
    <name>wend::PartOrderRow</name>
    <message>
        <source>In Front from Here</source>
        <translation>ここから前面</translation>
    </message>
    <message>
        <source>From the shown time on the part is in front of all others; before, it stays where it is.</source>
        <translation>表示中の時刻から、このパーツはほかのすべての前になります。それより前は変わりません。</translation>
    </message>
    <message>
        <source>Behind from Here</source>
        <translation>ここから背面</translation>
    </message>
    <message>
        <source>From the shown time on the part is behind all others; before, it stays where it is.</source>
        <translation>表示中の時刻から、このパーツはほかのすべての後ろになります。それより前は変わりません。</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>変えない</translation>
    </message>
    <message>
        <source>Removes all changes of the order of this part.</source>
        <translation>このパーツの順序の変更をすべて取り除きます。</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>順序を保つ</translation>
    </message>
    <message>
        <source>In front from here on</source>
        <translation>ここから前面にする</translation>
    </message>
    <message>
        <source>Behind from here on</source>
        <translation>ここから背面にする</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Changes at %1</source>
        <translation>%1 に変更</translation>
    </message>
</context>
<context>
    <name>wend::PictureActions</name>
    <message>
        <source>&amp;Add</source>
        <translation>追加(&amp;A)</translation>
    </message>
    <message>
        <source>What you draw will bend, too; Ctrl takes it away instead</source>
        <translation>描いた部分も変形させます。Ctrl で除外</translation>
    </message>
    <message>
        <source>&amp;Take Away</source>
        <translation>除外(&amp;T)</translation>
    </message>
    <message>
        <source>What you draw will not bend; Ctrl adds it instead</source>
        <translation>描いた部分は変形させません。Ctrl で追加</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen; also [ and ]</source>
        <translation>画面上でのブラシの幅。[ と ] でも変更できます</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source> %</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much colours may differ; this also changes the last click. Also [ and ]</source>
        <translation>色がどれだけ離れてよいか。最後のクリックにも効きます。[ と ] でも</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>パーツにする(&amp;P)</translation>
    </message>
    <message>
        <source>What you draw becomes a part that bends by itself; what is behind it is filled</source>
        <translation>描いた部分が単独で曲がるパーツになります。背後は補完されます</translation>
    </message>
</context>
<context>
    <name>wend::PictureDialog</name>
    <message>
        <source>%1 has no transparency: the background is that of the view.</source>
        <translation>%1 は透明を持てません。背景は表示と同じです。</translation>
    </message>
    <message>
        <source>&amp;Proportions of the view</source>
        <translation>ビューの縦横比(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>背景を透明に(&amp;T)</translation>
    </message>
    <message>
        <source>P&amp;ins and axes</source>
        <translation>ピンと軸(&amp;I)</translation>
    </message>
    <message>
        <source>Export View</source>
        <translation>ビューを書き出し</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>書き出すファイルの種類。</translation>
    </message>
    <message>
        <source>Proportions of the view</source>
        <translation>ビューの縦横比</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the view shows.</source>
        <translation>幅と高さを連動させ、ビューと同じ範囲を画像にします。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>画像の幅（ピクセル）。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the picture in pixels; it decides how large the solid is.</source>
        <translation>画像の高さ（ピクセル）。ソリッドの大きさを決めます。</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>背景を透明に</translation>
    </message>
    <message>
        <source>Only the solid, without a background.</source>
        <translation>背景なしで、ソリッドだけを書き出します。</translation>
    </message>
    <message>
        <source>Pins and axes</source>
        <translation>ピンと軸</translation>
    </message>
    <message>
        <source>Pins, their paths and the axes, as large as in the window.</source>
        <translation>ピン、そのパス、軸を、ウィンドウと同じ大きさで含めます。</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>形式(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>幅(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高さ(&amp;H)</translation>
    </message>
    <message>
        <source>Width and height must be between %1 and %2 pixels.</source>
        <translation>幅と高さは %1 ～ %2 ピクセルの範囲で指定してください。</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 ピクセル</translation>
    </message>
    <message>
        <source>&amp;Legend of the overlay</source>
        <translation>オーバーレイの凡例(&amp;L)</translation>
    </message>
    <message>
        <source>Legend of the overlay</source>
        <translation>オーバーレイの凡例</translation>
    </message>
    <message>
        <source>The colours of the overlay and their values.</source>
        <translation>オーバーレイの色とその値。</translation>
    </message>
    <message>
        <source>Show the colour overlay first: it has the legend.</source>
        <translation>先にカラーオーバーレイを表示してください。凡例はそこにあります。</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>フィルムを書き出す</translation>
    </message>
</context>
<context>
    <name>wend::PictureKeeper</name>
    <message>
        <source>The picture “%1” was changed by another program.</source>
        <translation>画像「%1」は別のプログラムで変更されました。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>そのまま</translation>
    </message>
    <message>
        <source>Reload picture</source>
        <translation>画像を再読み込み</translation>
    </message>
    <message>
        <source>Replace Picture</source>
        <translation>画像を置き換え</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Replace picture</source>
        <translation>画像を置き換え</translation>
    </message>
    <message>
        <source>The picture cannot be read. %1</source>
        <translation>画像を読み込めません。%1</translation>
    </message>
    <message>
        <source>It has %1 × %2 pixels, and the picture before had %3 × %4.</source>
        <translation>大きさは %1 × %2 ピクセルで、前の画像は %3 × %4 でした。</translation>
    </message>
    <message>
        <source>This picture has other proportions. %1</source>
        <translation>この画像は縦横比が違います。%1</translation>
    </message>
    <message>
        <source>The picture has other proportions now. %1</source>
        <translation>画像の縦横比が変わりました。%1</translation>
    </message>
    <message>
        <source>Pins and paths are scaled with it. %1</source>
        <translation>ピンと軌道も合わせて拡大縮小しました。%1</translation>
    </message>
    <message>
        <source>Change drawing size</source>
        <translation>図の大きさを変更</translation>
    </message>
</context>
<context>
    <name>wend::PinActions</name>
    <message>
        <source>&amp;Pins</source>
        <translation>ピン(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>ロック(&amp;L)</translation>
    </message>
    <message>
        <source>The selected pins are neither moved nor removed until unlocked</source>
        <translation>選択したピンを、ロックを解除するまで移動も削除もできないようにします</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隠す(&amp;H)</translation>
    </message>
    <message>
        <source>The selected pins still hold, but are neither drawn nor picked</source>
        <translation>選択したピンを、効かせたまま表示も選択もされないようにします</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>すべて表示(&amp;S)</translation>
    </message>
    <message>
        <source>Show all hidden pins again</source>
        <translation>隠したピンをすべて再び表示します</translation>
    </message>
    <message>
        <source>Alt+Shift+H</source>
        <translation>Alt+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Group…</source>
        <translation>グループ化(&amp;G)…</translation>
    </message>
    <message>
        <source>Put the selected pins under a heading of the list</source>
        <translation>選択したピンを、リストの見出しの下にまとめます</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>グループ解除(&amp;U)</translation>
    </message>
    <message>
        <source>Take the selected pins out of their groups</source>
        <translation>選択したピンをグループから外します</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Lin&amp;k</source>
        <translation>リンク(&amp;K)</translation>
    </message>
    <message>
        <source>The selected pins move together, whichever of them is dragged</source>
        <translation>選択したピンのどれをドラッグしても、すべて一緒に動くようにします</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>ミラー(&amp;M)</translation>
    </message>
    <message>
        <source>Set pins at the mirror images of the selected ones, across the middle of the shape, with mirrored motions</source>
        <translation>形状の中央を軸として、選択したピンと対称の位置に、対称のモーションを持つピンを打ちます</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Mirror M&amp;otion</source>
        <translation>モーションをミラー(&amp;O)</translation>
    </message>
    <message>
        <source>The selected pins move to the other side instead</source>
        <translation>選択したピンが反対側へ動くようにします</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>茶</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>ターコイズ</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>プラム</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>色(&amp;C)</translation>
    </message>
    <message>
        <source>By &amp;Place in the List</source>
        <translation>リストの順番で決める(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>その他(&amp;O)…</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>まずピンを選択してください。</translation>
    </message>
    <message>
        <source>The selected pin is in no group.</source>
        <translation>選択したピンはどのグループにも入っていません。</translation>
    </message>
    <message>
        <source>Select several pins first.</source>
        <translation>まず複数のピンを選択してください。</translation>
    </message>
    <message>
        <source>Select a pin that moves.</source>
        <translation>動くピンを選択してください。</translation>
    </message>
    <message>
        <source>No pin is hidden.</source>
        <translation>隠れているピンはありません。</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>グループ化</translation>
    </message>
    <message>
        <source>Name of the group:</source>
        <translation>グループ名：</translation>
    </message>
    <message>
        <source>Colour of the Pin</source>
        <translation>ピンの色</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Mo&amp;ve</source>
        <translation>移動(&amp;V)</translation>
    </message>
    <message>
        <source>Drag pins to move them; in a solid, also by the arrows</source>
        <translation>ピンをドラッグで移動。立体では矢印でも</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>回転(&amp;R)</translation>
    </message>
    <message>
        <source>Drag to rotate the selected pins; in a solid, by the rings</source>
        <translation>ドラッグで選択したピンを回転。立体ではリングで</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>拡大・縮小(&amp;A)</translation>
    </message>
    <message>
        <source>Drag to scale the selected pins; in a solid, by the ring</source>
        <translation>ドラッグで選択したピンを拡大・縮小。立体ではリングで</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>まず画像を開いてください。</translation>
    </message>
    <message>
        <source>Select &amp;Pins</source>
        <translation>ピンを選択(&amp;P)</translation>
    </message>
    <message>
        <source>What the pin tool and the select tool draw around pins to select them</source>
        <translation>ピンツールまたは選択ツールで、ピンの横からドラッグして選択するときの形</translation>
    </message>
    <message>
        <source>By &amp;Rectangle</source>
        <translation>長方形(&amp;R)</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>By &amp;Lasso</source>
        <translation>なげなわ(&amp;L)</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>By &amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>スナップ(&amp;N)</translation>
    </message>
    <message>
        <source>New pins sit on corners of the mesh instead of where you click</source>
        <translation>新しいピンを、クリックした位置ではなくメッシュの頂点に打ちます</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ].</source>
        <translation>画面上でのブラシの直径。[ と ] のキーでも変更できます。</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pin for the Whole &amp;Animation</source>
        <translation>アニメーション全体で固定(&amp;A)</translation>
    </message>
    <message>
        <source>The selected pins hold from the start of the animation to its end, not only from the time at which they were set</source>
        <translation>選択したピンは、設定した時刻からではなく、アニメーションの最初から最後まで固定します</translation>
    </message>
    <message>
        <source>The selected pin already holds for the whole animation.</source>
        <translation>選択したピンは、すでにアニメーション全体で固定しています。</translation>
    </message>
</context>
<context>
    <name>wend::PinList</name>
    <message>
        <source>Pins</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>Does not hold at the time shown.</source>
        <translation>表示中の時刻では効いていません。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow keys move them. The eye hides, the lock protects from changes; a right-click groups, links and mirrors.</source>
        <translation>ここでピンを選択します。F2 で名前を変更、Delete で削除、Enter で画像に移り、矢印キーで動かせます。目のアイコンで隠し、錠のアイコンで変更から保護します。右クリックでグループ化、リンク、ミラー。</translation>
    </message>
    <message>
        <source>Moves together with others</source>
        <translation>ほかのピンと一緒に動きます</translation>
    </message>
    <message>
        <source>Hidden: a click shows it</source>
        <translation>非表示：クリックで表示します</translation>
    </message>
    <message>
        <source>A click hides it</source>
        <translation>クリックで隠します</translation>
    </message>
    <message>
        <source>Locked: a click unlocks it</source>
        <translation>ロック中：クリックで解除します</translation>
    </message>
    <message>
        <source>A click locks it</source>
        <translation>クリックでロックします</translation>
    </message>
    <message>
        <source>No pins yet</source>
        <translation>ピンはまだありません</translation>
    </message>
</context>
<context>
    <name>wend::ProblemRemedies</name>
    <message>
        <source>Use Multigrid</source>
        <translation>マルチグリッドを使う</translation>
    </message>
    <message>
        <source>Half as Many Vertices</source>
        <translation>頂点を半分にする</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>wend::Properties</name>
    <message>
        <source>Advanced</source>
        <translation>詳細設定</translation>
    </message>
    <message>
        <source>The same in numbers, for those who want them.</source>
        <translation>同じ設定を数値で指定します。</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>細かさ</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>ペイント</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流れ</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>計測</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>諸元</translation>
    </message>
    <message>
        <source>Size, area, volume and edges, the quality of the cells, and gaps that a cage closes.</source>
        <translation>大きさ、面積、体積、辺、セルの品質、ケージが閉じる隙間。</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>フィルム</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>グループ</translation>
    </message>
</context>
<context>
    <name>wend::PropertiesRail</name>
    <message>
        <source>Opens this part of the properties over the view; Esc closes it.</source>
        <translation>プロパティのこの部分を表示の上に開きます。Esc で閉じます。</translation>
    </message>
</context>
<context>
    <name>wend::ReachRow</name>
    <message>
        <source>Pull reaches</source>
        <translation>引きの届く範囲</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads. Near: close to the pin, sharp. Far: soft and wide.</source>
        <translation>ピンを引く力がどこまで広がるか。近く：ピンのそばだけで鋭く。遠く：柔らかく広く。</translation>
    </message>
    <message>
        <source>Pull &amp;reaches</source>
        <translation>引きの届く範囲(&amp;R)</translation>
    </message>
    <message>
        <source>near</source>
        <translation>近く</translation>
    </message>
    <message>
        <source>far</source>
        <translation>遠く</translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>このプロジェクトの平滑化は論文と同じ λ によるもので、強さはファイルに書かれています。</translation>
    </message>
</context>
<context>
    <name>wend::RegionList</name>
    <message>
        <source>The mesh is equally fine everywhere: brush over what should be finer or coarser.</source>
        <translation>メッシュはどこも同じ細かさです。細かく、または粗くする部分をブラシでなぞってください。</translation>
    </message>
    <message>
        <source>Nothing has an order of its own: brush over what should lie in front or behind.</source>
        <translation>順序を指定した部分はありません。手前または奥にする部分をブラシでなぞってください。</translation>
    </message>
    <message>
        <source>Where the mesh is finer or coarser</source>
        <translation>メッシュの細かい部分と粗い部分</translation>
    </message>
    <message>
        <source>What lies in front</source>
        <translation>手前にあるもの</translation>
    </message>
    <message>
        <source>The strokes and regions so far; where two overlap, the upper one counts. A click shows where it lies and its number, a double-click changes its name.</source>
        <translation>現在のストロークと領域。同じ場所に 2 つあれば上のものが有効です。クリックで位置と数値を表示、ダブルクリックで名前を変更します。</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>辺の長さ</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>順序</translation>
    </message>
    <message>
        <source>How long edges are there, compared with elsewhere: less is finer, more is coarser.</source>
        <translation>ほかの部分に対する辺の長さ。小さいほど細かく、大きいほど粗くなります。</translation>
    </message>
    <message>
        <source>Greater than 0 lies in front, less than 0 behind.</source>
        <translation>0 より大きいと手前、小さいと奥になります。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Removes the chosen region.</source>
        <translation>選択した領域を削除します。</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>細かい部分と粗い部分</translation>
    </message>
    <message>
        <source>In front and behind</source>
        <translation>手前と奥</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>辺の長さ(&amp;D)</translation>
    </message>
    <message>
        <source>O&amp;rder</source>
        <translation>順序(&amp;R)</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>辺の長さを変更</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>順序を変更</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>領域を削除</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>片側</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>領域名を変更</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>領域を追加</translation>
    </message>
    <message>
        <source>A ball, a box or a half-space in the middle, or what the selected handle holds as a region; its numbers can then be changed.</source>
        <translation>中央に置く球、直方体、半空間、または選択したハンドルがつかむ領域。数値は後から変更できます。</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>境界のぼかし</translation>
    </message>
    <message>
        <source>Over what width the size blends into that around it, in the file&apos;s units.</source>
        <translation>周囲のサイズへ移り変わる幅（ファイルの単位）。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>直方体</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>半空間</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>グラデーション</translation>
    </message>
    <message>
        <source>Region of the selected handle</source>
        <translation>選択したハンドルの領域</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>境界のぼかし(&amp;G)</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>領域を変更</translation>
    </message>
    <message>
        <source>Add size region</source>
        <translation>サイズ領域を追加</translation>
    </message>
    <message>
        <source>First select a pin that holds a ball, a box or one side.</source>
        <translation>まず球、ブロック、片側のいずれかをつかむピンを選択してください。</translation>
    </message>
    <message>
        <source>Beneath them: the factors in %1.</source>
        <translation>その下にあるもの：%1 の倍率。</translation>
    </message>
    <message>
        <source>The surface&apos;s triangles are kept, and only the inside changes. “Refine surface” in the panel “Mesh” allows them to be split, too.</source>
        <translation>サーフェスの三角形は保たれ、内部だけが変わります。「メッシュ」パネルの「サーフェスを細分化」をオンにすると、三角形も分割されます。</translation>
    </message>
</context>
<context>
    <name>wend::RegionNumbers</name>
    <message>
        <source>Numbers of the region</source>
        <translation>領域の数値</translation>
    </message>
    <message>
        <source>As x, y and z, in the coordinates of the rest shape.</source>
        <translation>x、y、z の値（元の形の座標）。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>直方体</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>半空間</translation>
    </message>
    <message>
        <source>Kind of region</source>
        <translation>領域の種類</translation>
    </message>
    <message>
        <source>What the region is; another kind keeps its place.</source>
        <translation>領域の種類。変更しても位置は変わりません。</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>領域(&amp;R)</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>from</source>
        <translation>始点</translation>
    </message>
    <message>
        <source>point of the plane</source>
        <translation>平面上の点</translation>
    </message>
    <message>
        <source>to</source>
        <translation>終点</translation>
    </message>
    <message>
        <source>direction into it</source>
        <translation>内側への方向</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>The radius of the ball.</source>
        <translation>球の半径。</translation>
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
        <translation>領域</translation>
    </message>
    <message>
        <source>There is no vertex in this region: nothing was changed.</source>
        <translation>この領域に頂点がないため、変更しませんでした。</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>領域を変更</translation>
    </message>
    <message numerus="yes">
        <source>Vertices: %n</source>
        <translation>
            <numerusform>頂点 %n 個</numerusform>
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
        <translation>角度を保つ(&amp;H)</translation>
    </message>
    <message>
        <source>How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. In the shape&apos;s own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does the same.</source>
        <translation>ピンが周りをつかむ範囲。0 は点、それ以上は円、立体では球をつかみます（形状の単位、画像ではピクセル）。ピンを Ctrl+Shift+ドラッグしても変更できます。</translation>
    </message>
    <message>
        <source>The pin keeps the angle that the picture has there now, as a small circle; without it, the picture turns freely around the pin.</source>
        <translation>ピンは小さな円として、画像がそこで今持っている角度を保ちます。オフにすると、画像はピンの周りを自由に回ります。</translation>
    </message>
</context>
<context>
    <name>wend::RidingOffer</name>
    <message>
        <source>A part has no pin and stays behind: let it ride on “%1”?</source>
        <translation>1 個のパーツにピンがなく、取り残されます。「%1」に追従させますか?</translation>
    </message>
    <message>
        <source>A part has no pin and stays behind: let it ride on what is beside it?</source>
        <translation>1 個のパーツにピンがなく、取り残されます。隣のものに追従させますか?</translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on “%1”?</source>
        <translation>
            <numerusform>%n 個のパーツにピンがなく、取り残されます。「%1」に追従させますか?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on what is beside them?</source>
        <translation>
            <numerusform>%n 個のパーツにピンがなく、取り残されます。隣のものに追従させますか?</numerusform>
        </translation>
    </message>
    <message>
        <source>Let parts ride</source>
        <translation>パーツを追従させる</translation>
    </message>
    <message>
        <source>Let It Ride</source>
        <translation>追従させる</translation>
    </message>
    <message>
        <source>Let Them Ride</source>
        <translation>追従させる</translation>
    </message>
</context>
<context>
    <name>wend::ShapeCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation>画像とそのピン</translation>
    </message>
</context>
<context>
    <name>wend::ShapeNotices</name>
    <message>
        <source>“Refine surface” in the panel “Mesh” allows the surface&apos;s triangles to be split.</source>
        <translation>「メッシュ」パネルの「サーフェスを細分化」をオンにすると、サーフェスの三角形を分割できます。</translation>
    </message>
    <message>
        <source>Pin It</source>
        <translation>ピンで留める</translation>
    </message>
    <message>
        <source>A part is joined to the rest at a single point, and may swing around it unless a pin holds it.</source>
        <translation>一点だけでつながっている部分があり、ピンで留めないとそこで揺れ動くことがあります。</translation>
    </message>
    <message numerus="yes">
        <source>%n parts are joined to the rest at single points, and may swing around them unless pins hold them.</source>
        <translation>
            <numerusform>一点だけでつながっている部分が %n か所あり、ピンで留めないとそこで揺れ動くことがあります。</numerusform>
        </translation>
    </message>
    <message>
        <source>See Why</source>
        <translation>理由を見る</translation>
    </message>
    <message>
        <source>Fill All, with Labels</source>
        <translation>すべて満たしラベルを付ける</translation>
    </message>
    <message>
        <source>Leave Holes</source>
        <translation>穴のままにする</translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>Widen %1</source>
        <translation>%1 を広げる</translation>
    </message>
    <message>
        <source>%1 cannot go further: %2</source>
        <translation>%1 はこれ以上動かせません：%2</translation>
    </message>
    <message>
        <source>Cancelled: everything is as it was before the last change.</source>
        <translation>キャンセルしました。すべて最後の変更の前の状態です。</translation>
    </message>
    <message>
        <source>Meshing was cancelled. Any change, such as fewer vertices, starts it again.</source>
        <translation>メッシュ化をキャンセルしました。頂点数を減らすなど、何か変更すると再び実行されます。</translation>
    </message>
    <message>
        <source>The motion was cancelled. Any change computes it again.</source>
        <translation>モーションの計算をキャンセルしました。何か変更すると再び計算されます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>No pin was set: this place lies outside the shape.</source>
        <translation>ピンは打てません。ここは形状の外です。</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 を追加</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 を変更</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 を移動</translation>
    </message>
    <message>
        <source>%1 does not hold the shape at the time shown.</source>
        <translation>%1 は表示中の時刻では効いていません。</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 を拡大・縮小</translation>
    </message>
    <message>
        <source>This replaces what came after; Undo brings it back.</source>
        <translation>これより後の動きは置き換えられました。取り消しで元に戻せます。</translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation>
            <numerusform>%n 個のピン</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1（ミラー）</translation>
    </message>
    <message>
        <source>No pin was set where the mirror image lies outside the shape.</source>
        <translation>対称の位置が形状の外になるところには、ピンは打たれません。</translation>
    </message>
    <message>
        <source>There is already a pin where the mirror image would be.</source>
        <translation>対称の位置にはすでにピンがあります。</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 をミラー</translation>
    </message>
    <message>
        <source>Mirror the motion of %1</source>
        <translation>%1 のモーションをミラー</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 をロック</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 のロックを解除</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 を隠す</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 を表示</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>%1 のグループを解除</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>%1 をグループ化</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>グループ名を変更</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>%1 の色を変更</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>%1 をリンク</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>%1 のリンクを解除</translation>
    </message>
    <message>
        <source>%1 is locked. A right-click or the list of pins unlocks it.</source>
        <translation>%1 はロックされています。右クリックまたはピンのリストで解除できます。</translation>
    </message>
    <message>
        <source>%1 are locked. A right-click or the list of pins unlocks them.</source>
        <translation>%1 はロックされています。右クリックまたはピンのリストで解除できます。</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>%1 を記録</translation>
    </message>
    <message>
        <source>Recorded. K plays it; record other pins from the same time, and they move together.</source>
        <translation>記録しました。K で再生します。同じ時刻から他のピンを記録すると、一緒に動きます。</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>パスを編集</translation>
    </message>
    <message>
        <source>Draw the path of %1</source>
        <translation>%1 のパスを描く</translation>
    </message>
    <message>
        <source>K plays it; draw the paths of other pins from the same time, and they move together.</source>
        <translation>K で再生。同じ時刻から他のピンのパスを描くと、一緒に動きます。</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>緩める</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 を回転</translation>
    </message>
    <message>
        <source>This replaces what %1 did later; Undo brings it back.</source>
        <translation>%1 のこれより後の動きは置き換えられました。取り消しで元に戻せます。</translation>
    </message>
    <message>
        <source>This circle is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>円がメッシュの目より小さくなっています。円を大きくするか、メッシュを細かくしてください。</translation>
    </message>
    <message>
        <source>This ball is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>球がメッシュの目より小さくなっています。球を大きくするか、メッシュを細かくしてください。</translation>
    </message>
    <message>
        <source>Pin %1 for the whole animation</source>
        <translation>%1 をアニメーション全体で固定</translation>
    </message>
    <message>
        <source>The film is longer by a second: what you had timed keeps its times.</source>
        <translation>フィルムが 1 秒長くなりました。決めた時刻はそのままです。</translation>
    </message>
    <message>
        <source>The film is longer by a second. At an earlier time a drag sets the pose there.</source>
        <translation>フィルムが 1 秒長くなりました。それより前の時刻でドラッグすると、その時刻のポーズになります。</translation>
    </message>
    <message>
        <source>Posed at %1 s: what comes before and after stays.</source>
        <translation>%1 秒のポーズです。前後はそのままです。</translation>
    </message>
    <message>
        <source>No pose was set where a pin begins, rotates or does not hold: show another time.</source>
        <translation>ピンの始まり、回転中、固定していない時刻にはポーズを設定できません。別の時刻を表示してください。</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 を固定</translation>
    </message>
    <message>
        <source>The last move goes straight there now. Motion ▸ Keep the Path leads pins on instead.</source>
        <translation>最後の動きはまっすぐそこへ向かいます。モーション ▸ 経路を残す を使うと、ピンはその先へ動きます。</translation>
    </message>
    <message>
        <source>%1 is in a part that is locked. The list of parts unlocks it.</source>
        <translation>%1 はロックされたパーツにあります。パーツのリストで解除できます。</translation>
    </message>
    <message>
        <source>A part is still being made. Pins can be dragged as soon as it is there.</source>
        <translation>パーツを作成中です。できあがるとピンをドラッグできます。</translation>
    </message>
    <message>
        <source>The motion stops at %1 s: %2</source>
        <translation>モーションは %1 秒で止まります：%2</translation>
    </message>
</context>
<context>
    <name>wend::ShortcutDialog</name>
    <message>
        <source>&amp;None</source>
        <translation>なし(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>標準(&amp;S)</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Search for an action or for keys</source>
        <translation>操作またはキーを検索</translation>
    </message>
    <message>
        <source>&amp;All Standard</source>
        <translation>すべて標準に戻す(&amp;A)</translation>
    </message>
    <message>
        <source>Give every action the keys that it has in a new Wend</source>
        <translation>すべての操作を、インストール直後の Wend のキーに戻します</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>キー(&amp;K)</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Click here, then press the keys</source>
        <translation>ここをクリックしてからキーを押してください</translation>
    </message>
    <message>
        <source>Leave the chosen action without keys</source>
        <translation>選択した操作のキーをなくします</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it has in a new Wend</source>
        <translation>選択した操作を、インストール直後の Wend のキーに戻します</translation>
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
        <translation>操作を選び、割り当てるキーを押してください。</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: the canvas uses it.</source>
        <translation>%1 はキャンバスが使うため選べません。</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>「%1」</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>%1 から外しました。</translation>
    </message>
</context>
<context>
    <name>wend::SideWindows</name>
    <message>
        <source>As it was opened</source>
        <translation>開いたときの状態</translation>
    </message>
    <message>
        <source>What was done; a click goes back or forward to that step.</source>
        <translation>これまでの操作です。クリックするとその時点に戻る、または進みます。</translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation>Wend について</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;画像とソリッドを、流れるように変形させます。&lt;/p&gt;&lt;p&gt;次の論文に基づいています：J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;GNU Affero General Public License バージョン 3 またはそれ以降に基づくフリーソフトウェアです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>History</source>
        <translation>ヒストリー</translation>
    </message>
</context>
<context>
    <name>wend::SolidActions</name>
    <message>
        <source>Through the &amp;Solid</source>
        <translation>ソリッドを透過(&amp;S)</translation>
    </message>
    <message>
        <source>Rectangle, lasso and brush also take or select what is hidden</source>
        <translation>長方形、なげなわ、ブラシで、隠れた部分もつかむ、または選択します</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Grab Beyond the &amp;Cut</source>
        <translation>断面の向こう側をつかむ(&amp;C)</translation>
    </message>
    <message>
        <source>Take hold of all that the cut takes away, as one handle</source>
        <translation>断面で取り除かれた部分すべてを 1 つのハンドルとしてつかみます</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>スキン(&amp;K)</translation>
    </message>
    <message>
        <source>Show the detailed or textured surface embedded in the solid; off: the border of the tetrahedra, which bend</source>
        <translation>ソリッドに追従する、精細な、またはテクスチャ付きのサーフェスを表示します。オフの場合は、変形している四面体の境界を表示します</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Choose Sk&amp;in…</source>
        <translation>スキンを選択(&amp;I)…</translation>
    </message>
    <message>
        <source>Embed a detailed, perhaps textured surface from a file in the solid</source>
        <translation>テクスチャ付きも可能な精細なサーフェスをファイルから読み込み、ソリッドに追従させます</translation>
    </message>
    <message>
        <source>Re&amp;move Skin</source>
        <translation>スキンを削除(&amp;M)</translation>
    </message>
    <message>
        <source>Show and export the solid with its own surface again</source>
        <translation>ソリッドの表示と書き出しを、元のサーフェスに戻します</translation>
    </message>
    <message>
        <source>&amp;Flat Faces</source>
        <translation>フラットシェーディング(&amp;F)</translation>
    </message>
    <message>
        <source>Shade every triangle by itself instead of smoothly</source>
        <translation>滑らかにせず、三角形ごとに陰影を付けます</translation>
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
        <translation>遠近感なしで表示します</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>&amp;Cut Open</source>
        <translation>断面表示(&amp;C)</translation>
    </message>
    <message>
        <source>Look inside along a plane; an arrow and rings move and tilt it</source>
        <translation>平面で切って内部を見ます。矢印で移動、リングで傾けられます</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Look along an axis of the world</source>
        <translation>ワールドの軸に沿って見ます</translation>
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
        <translation>後ろ(&amp;B)</translation>
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
        <translation>斜め(&amp;O)</translation>
    </message>
    <message>
        <source>Look from the side and above</source>
        <translation>斜め上から見ます</translation>
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
        <translation>右または中ボタンで回転、Shift と合わせて移動、ホイールでズーム</translation>
    </message>
    <message>
        <source>Like &amp;VTK</source>
        <translation>VTK 方式(&amp;V)</translation>
    </message>
    <message>
        <source>Left button turns, middle moves, right zooms, as in ParaView</source>
        <translation>左ボタンで回転、中ボタンで移動、右ボタンでズーム（ParaView と同じ）</translation>
    </message>
    <message>
        <source>Like &amp;Blender</source>
        <translation>Blender 方式(&amp;B)</translation>
    </message>
    <message>
        <source>Middle button turns, with Shift moves, with Ctrl zooms</source>
        <translation>中ボタンで回転、Shift と合わせて移動、Ctrl と合わせてズーム</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>ソリッド(&amp;S)</translation>
    </message>
    <message>
        <source>L&amp;ook from</source>
        <translation>視点(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>ナビゲーション(&amp;N)</translation>
    </message>
    <message>
        <source>The solid has neither a detailed surface nor materials.</source>
        <translation>このソリッドには精細なサーフェスもマテリアルもありません。</translation>
    </message>
    <message>
        <source>No detailed surface was chosen for the solid.</source>
        <translation>このソリッドには精細なサーフェスが選択されていません。</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>メッシュはファイルから読み込まれ、そのまま使われます。</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>まずソリッドを開いてください。</translation>
    </message>
    <message>
        <source>Which axis of the world points up in the view; kept with the project</source>
        <translation>ビューで上を向くワールドの軸。プロジェクトとともに保存されます</translation>
    </message>
    <message>
        <source>&amp;X Points Up</source>
        <translation>X が上(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Y Points Up</source>
        <translation>Y が上(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Z Points Up</source>
        <translation>Z が上(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>上向きの軸(&amp;U)</translation>
    </message>
</context>
<context>
    <name>wend::SolidCanvas</name>
    <message>
        <source>there is not enough memory for a picture of %1 x %2 pixels</source>
        <translation>%1 x %2 ピクセルの画像にはメモリーが足りません</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>画像を書き出しています…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>セル %1</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>映像を書き出しています…</translation>
    </message>
</context>
<context>
    <name>wend::SolidWorkshop</name>
    <message>
        <source>Solids need OpenGL 3.3, which this system does not have. The command line (wend run) still works with them.</source>
        <translation>ソリッドには OpenGL 3.3 が必要ですが、このシステムにはありません。コマンドライン（wend run）では使えます。</translation>
    </message>
    <message>
        <source>These pictures of the surface cannot be read: %1</source>
        <translation>サーフェスの次の画像を読み込めません：%1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>何も書き出されませんでした。%1</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>領域</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>形はまだ計算中です。少ししてからもう一度お試しください。</translation>
    </message>
</context>
<context>
    <name>wend::SoundTrack</name>
    <message>
        <source>The sound is not shown: that needs the program ffmpeg (Debian: sudo apt install ffmpeg).</source>
        <translation>音声を表示するにはプログラム ffmpeg が必要です (Debian: sudo apt install ffmpeg)。</translation>
    </message>
    <message>
        <source>The sound %1 cannot be read: is the file there?</source>
        <translation>音声 %1 を読み込めません。ファイルはありますか？</translation>
    </message>
</context>
<context>
    <name>wend::SpringOffer</name>
    <message>
        <source>What comes back leaves the shape a little different, so that a loop jumps. If the shape springs back fully, it is as it was.</source>
        <translation>ピンが元に戻っても形は少し変わり、ループがつながりません。完全に元へ戻すと、形は元のままです。</translation>
    </message>
    <message>
        <source>Spring Back Fully</source>
        <translation>完全に元へ戻す</translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation>画像にピンを打ち、引っぱって、流れるように変形。</translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation>ここに画像をドロップ</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation>画像、平面メッシュ、またはプロジェクトを選択します。</translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation>サンプルを試す</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>Five-minute tutorial</source>
        <translation>5 分でわかるチュートリアル</translation>
    </message>
    <message>
        <source>The first steps on a sample, one after another.</source>
        <translation>サンプルを使った最初の操作を、1 つずつ案内します。</translation>
    </message>
    <message>
        <source>Not saved when Wend ended</source>
        <translation>Wend の終了時に保存されていなかったもの</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>破棄…</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 を破棄</translation>
    </message>
    <message>
        <source>Deletes these changes for good.</source>
        <translation>この変更を完全に破棄します。</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.
PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too.</source>
        <translation>PNG、JPEG、TIFF、EXR、WebP などに対応。透明部分のある切り抜き画像が最適です。
PSD、ORA、KRA、SVG はレイヤーごと開きます。プロジェクト、メッシュ、ソリッドも開けます。</translation>
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
        <translation>ポインターの位置（画像のピクセル）</translation>
    </message>
    <message>
        <source>Area change</source>
        <translation>面積の変化</translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation>形状が変形前よりどれだけ大きく、または小さくなったか</translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation>面積 %1%</translation>
    </message>
    <message>
        <source>volume %1 %</source>
        <translation>体積 %1%</translation>
    </message>
</context>
<context>
    <name>wend::SurfaceCheck</name>
    <message>
        <source>Triangles with missing points</source>
        <translation>頂点が欠けた三角形</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>交差する三角形</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Edges of more than two</source>
        <translation>3 面以上が共有する辺</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>面積のない三角形</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>重複した三角形</translation>
    </message>
    <message>
        <source>Turned neighbours</source>
        <translation>向きが逆の隣接三角形</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>すべての点が同一平面上にあります。</translation>
    </message>
    <message>
        <source>Save List</source>
        <translation>リストを保存</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>テキスト (*.txt)</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>サーフェスを修復</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>ケージを作る</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>正確なサーフェスのみ</translation>
    </message>
    <message>
        <source>merge points (%1)</source>
        <translation>点の結合（%1）</translation>
    </message>
    <message>
        <source>drop triangles (%1)</source>
        <translation>三角形の除去（%1）</translation>
    </message>
    <message>
        <source>turn triangles (%1)</source>
        <translation>三角形の反転（%1）</translation>
    </message>
    <message>
        <source>fill holes (%1)</source>
        <translation>穴埋め（%1）</translation>
    </message>
    <message>
        <source>It would %1.</source>
        <translation>行われる処理：%1。</translation>
    </message>
    <message>
        <source>No simple step fixes this one.</source>
        <translation>この不具合を直す簡単な手順はありません。</translation>
    </message>
    <message>
        <source>add triangles (%1)</source>
        <translation>三角形を追加 (%1)</translation>
    </message>
    <message>
        <source>It would leave %1 of %2 faults.</source>
        <translation>%2 件中 %1 件の不具合が残ります。</translation>
    </message>
    <message>
        <source>Fix one fault</source>
        <translation>不具合を一つ修正</translation>
    </message>
    <message>
        <source>No simple steps fix all of these.</source>
        <translation>これらすべてを直す簡単な手順はありません。</translation>
    </message>
    <message>
        <source>Fix all faults of a kind</source>
        <translation>同じ種類の不具合をすべて修正</translation>
    </message>
    <message>
        <source>Looking for what fixes all of these …</source>
        <translation>すべてを直す方法を探しています…</translation>
    </message>
</context>
<context>
    <name>wend::SurfacePanel</name>
    <message>
        <source>Show them</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>リストを保存…</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修復</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>問題点</translation>
    </message>
    <message>
        <source>The kinds of faults, and how often each occurs.</source>
        <translation>問題の種類と、それぞれの件数。</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>前の箇所</translation>
    </message>
    <message>
        <source>Goes to the previous place where this is wrong.</source>
        <translation>この問題がある前の箇所を表示します。</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>次の箇所</translation>
    </message>
    <message>
        <source>Goes to the next place where this is wrong.</source>
        <translation>この問題がある次の箇所を表示します。</translation>
    </message>
    <message>
        <source>Show the triangles</source>
        <translation>三角形を表示</translation>
    </message>
    <message>
        <source>Colours the triangles that are wrong and shows them: what hides them is left out.</source>
        <translation>問題のある三角形に色を付けて表示します。手前で隠しているものは省かれます。</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>リストを保存</translation>
    </message>
    <message>
        <source>Writes the numbers of all wrong triangles and edges to a file.</source>
        <translation>問題のあるすべての三角形と辺の番号をファイルに書き出します。</translation>
    </message>
    <message>
        <source>Merges coincident points, drops degenerate and duplicate triangles, orients the others and fills small holes.</source>
        <translation>同じ位置の点を結合し、退化した三角形と重複した三角形を取り除き、向きをそろえ、小さな穴を埋めます。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>The surface is embedded in a cage</source>
        <translation>サーフェスはケージに追従しています</translation>
    </message>
    <message>
        <source>The surface bounds no solid</source>
        <translation>サーフェスがソリッドを囲んでいません</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>“Repair” helps.</source>
        <translation>「修復」で直せます。</translation>
    </message>
    <message>
        <source>“Repair” does not help: a cage around it can carry it.</source>
        <translation>「修復」では直せませんが、包むケージに追従させることができます。</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>正確なサーフェスのみ</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>ケージを作る</translation>
    </message>
    <message>
        <source>Removes the cage: without a repair there is then no solid.</source>
        <translation>ケージを取り除きます。修復しなければソリッドはなくなります。</translation>
    </message>
    <message>
        <source>Fills a cage of even cells around the surface, which is embedded in it.</source>
        <translation>サーフェスを包む均一なセルのケージを充填します。サーフェスはそれに追従します。</translation>
    </message>
    <message>
        <source>See the repair</source>
        <translation>修復をプレビュー</translation>
    </message>
    <message>
        <source>Shows the surface as the repair would leave it: what it adds in green, what stays wrong in red.</source>
        <translation>修復後のサーフェスを表示します。追加される部分は緑、問題が残る部分は赤で示します。</translation>
    </message>
    <message>
        <source>There is nothing that the simple repairs would change.</source>
        <translation>簡単な修復で変わるところはありません。</translation>
    </message>
    <message>
        <source>Fix this one</source>
        <translation>これを修正</translation>
    </message>
    <message>
        <source>Fixes only what is shown: what it adds is green, what it takes away or turns is yellow.</source>
        <translation>表示中の箇所だけを直します。追加は緑、削除や向きの変更は黄で示します。</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>すべて修正</translation>
    </message>
    <message>
        <source>Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no more edges than chosen below.</source>
        <translation>この種類のうち簡単な手順で直せるものを、一回で取り消せる一つの手順ですべて直します。穴は、辺の数が下で選んだ数以下のものだけです。</translation>
    </message>
    <message>
        <source>“Repair” does not help: the cage carries the surface as it is.</source>
        <translation>「修復」では直せませんが、サーフェスはそのままケージに追従します。</translation>
    </message>
    <message>
        <source>One hole has %1 edges: fill up to %1</source>
        <translation>1 つの穴は辺が %1 本：%1 本まで埋める</translation>
    </message>
    <message>
        <source>%1 holes have up to %2 edges: fill up to %2</source>
        <translation>%1 個の穴は辺が %2 本まで：%2 本まで埋める</translation>
    </message>
    <message>
        <source>No hole is larger</source>
        <translation>これより大きい穴はありません</translation>
    </message>
    <message>
        <source>Sets the largest hole that the repair fills to this.</source>
        <translation>修復で埋める最大の穴をこの値にします。</translation>
    </message>
</context>
<context>
    <name>wend::TimeRuler</name>
    <message>
        <source>Ruler</source>
        <translation>ルーラー</translation>
    </message>
    <message>
        <source>Drag to show another time; with Shift, mark the part that a loop repeats. A right-click counts frames, sets the frame rate, and adds markers</source>
        <translation>ドラッグで別の時刻を表示します。Shift を押すと、ループで繰り返す部分を指定します。右クリックでフレーム表示、フレームレート、マーカーを設定します</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>マーカーを移動</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>サイクルを変更</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>マーカーを追加</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>Rename Marker</source>
        <translation>マーカーの名前を変更</translation>
    </message>
    <message>
        <source>Name of the marker:</source>
        <translation>マーカーの名前:</translation>
    </message>
    <message>
        <source>Rename marker</source>
        <translation>マーカーの名前を変更</translation>
    </message>
    <message>
        <source>Frame &amp;Rate</source>
        <translation>フレームレート(&amp;R)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Cycle &amp;from Here</source>
        <translation>ここからサイクル(&amp;F)</translation>
    </message>
    <message>
        <source>Cycle &amp;to Here</source>
        <translation>ここまでサイクル(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;No Cycle</source>
        <translation>サイクルなし(&amp;N)</translation>
    </message>
    <message>
        <source>Remove cycle</source>
        <translation>サイクルを取り除く</translation>
    </message>
    <message>
        <source>&amp;Count Frames</source>
        <translation>フレームで数える(&amp;C)</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>マーカーを追加(&amp;M)</translation>
    </message>
    <message>
        <source>R&amp;ename Marker…</source>
        <translation>マーカーの名前を変更(&amp;E)…</translation>
    </message>
    <message>
        <source>Re&amp;move Marker</source>
        <translation>マーカーを取り除く(&amp;V)</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>マーカーを取り除く</translation>
    </message>
    <message>
        <source>Play the &amp;Sound</source>
        <translation>音声を再生(&amp;S)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Cycle: %1 to %2</source>
        <translation>サイクル：%1～%2</translation>
    </message>
    <message>
        <source>frames at %1 fps</source>
        <translation>フレーム、%1 fps</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>Show Key &amp;Poses</source>
        <translation>キーポーズを表示(&amp;P)</translation>
    </message>
</context>
<context>
    <name>wend::TimeScale</name>
    <message>
        <source>frame %1</source>
        <translation>フレーム %1</translation>
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
        <translation>時刻</translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation>モーションのどの時点を表示しているか。</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>How long the film is. The poses stay as they are, however fast it goes.</source>
        <translation>ムービーの長さ。速さが変わってもポーズは変わりません。</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>長さを変更</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>まだ何も動いていません。ピンをドラッグしてください。</translation>
    </message>
    <message>
        <source>%1 /</source>
        <translation>%1 /</translation>
    </message>
    <message>
        <source>Drag a pin to begin</source>
        <translation>ピンをドラッグして開始</translation>
    </message>
</context>
<context>
    <name>wend::Toolbox</name>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>What bends, and how finely</source>
        <translation>変形する範囲とその細かさ</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>ピン</translation>
    </message>
    <message>
        <source>Hold parts and drag them</source>
        <translation>部分をつかんでドラッグ</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>ペイント</translation>
    </message>
    <message>
        <source>What it is made of: soft, stiff, and what is kept where</source>
        <translation>材質：柔らかさ、剛性、どこで何を保つか</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>アニメーション</translation>
    </message>
    <message>
        <source>How it moves in time</source>
        <translation>時間とともにどう動くか</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>まず画像を開いてください。</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>まずソリッドを開いてください。</translation>
    </message>
    <message>
        <source>Write pictures, sequences, ST maps and meshes</source>
        <translation>画像、連番、ST マップ、メッシュを書き出します</translation>
    </message>
</context>
<context>
    <name>wend::TrackChoice</name>
    <message>
        <source>Move in time</source>
        <translation>時刻を変更</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>動きを削除</translation>
    </message>
    <message>
        <source>Remove motions</source>
        <translation>モーションを削除</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>イージングを変更</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>直線にする</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>簡略化</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>キーを移動</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>キーを移動</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>キーを貼り付け</translation>
    </message>
    <message>
        <source>Mirror keys</source>
        <translation>キーをミラー</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保つ</translation>
    </message>
    <message>
        <source>Nothing changes: where a pin begins it is at rest, and rotations keep their course.</source>
        <translation>変更はありません。ピンの始まりは静止状態で、回転の経過は変わりません。</translation>
    </message>
</context>
<context>
    <name>wend::TrackView</name>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>拡大・縮小</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>パス</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>時刻を変更</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>長さを変更</translation>
    </message>
    <message>
        <source>&amp;Remove Motion</source>
        <translation>動きを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears here, pin by pin.</source>
        <translation>まだ何も動いていません。ピンをドラッグするか、Ctrl を押しながら記録すると、動きがピンごとにここに並びます。</translation>
    </message>
    <message>
        <source>Change when it holds</source>
        <translation>固定する期間を変更</translation>
    </message>
    <message>
        <source>&amp;Remove Motions</source>
        <translation>モーションを削除(&amp;R)</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>イージング</translation>
    </message>
    <message>
        <source>&amp;Paste at the Time Shown</source>
        <translation>表示時刻に貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Paste M&amp;irrored</source>
        <translation>ミラーして貼り付け(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Straighten</source>
        <translation>直線にする(&amp;S)</translation>
    </message>
    <message>
        <source>Simplify to &amp;Keys</source>
        <translation>キーに簡略化(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Few</source>
        <translation>少なく(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Some</source>
        <translation>中くらい(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>多く(&amp;M)</translation>
    </message>
    <message>
        <source>Key at %1</source>
        <translation>キー：%1</translation>
    </message>
    <message>
        <source>Holds from %1 to %2</source>
        <translation>%1から%2まで固定</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4</source>
        <translation>%1：%2～%3、%4</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>リニア(&amp;L)</translation>
    </message>
    <message>
        <source>Slow &amp;before It</source>
        <translation>手前でゆっくり(&amp;B)</translation>
    </message>
    <message>
        <source>Slow &amp;after It</source>
        <translation>直後はゆっくり(&amp;A)</translation>
    </message>
    <message>
        <source>Slow on B&amp;oth Sides</source>
        <translation>前後でゆっくり(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Hold to the Next</source>
        <translation>次のキーまで保つ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>ミラー(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Remove Keys</source>
        <translation>キーを削除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Remove Key</source>
        <translation>キーを削除(&amp;R)</translation>
    </message>
    <message>
        <source>A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right another time, with Alt they move the chosen bar or keys</source>
        <translation>ピンごとに 1 行、動きごとに 1 本のバー。上下でピンを、左右で時刻を選び、Alt を押すと選んだバーやキーが動きます</translation>
    </message>
    <message>
        <source>Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds</source>
        <translation>キー (ひし形) またはバーを別の時刻へドラッグ。Shift、Ctrl、または囲む枠で複数を選択。右クリックでイージング、保持、コピー、ミラー。線の端はピンが固定する期間を示します</translation>
    </message>
    <message>
        <source>Easing Curve</source>
        <translation>イージング曲線</translation>
    </message>
    <message>
        <source>Easing C&amp;urve…</source>
        <translation>イージング曲線(&amp;U)…</translation>
    </message>
</context>
<context>
    <name>wend::Tutorial</name>
    <message>
        <source>End</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Ends the tutorial; the picture stays open</source>
        <translation>チュートリアルを終了します。画像は開いたままです</translation>
    </message>
    <message>
        <source>Only what is pinned holds. &lt;b&gt;Click a hoof&lt;/b&gt; of the giraffe to pin it.</source>
        <translation>ピンで留めたところだけが固定されます。キリンの&lt;b&gt;ひづめを 1 つクリック&lt;/b&gt;して、ピンを打ってください。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pin the other hooves&lt;/b&gt;, too, with a click each. Ctrl+Z undoes a pin.</source>
        <translation>&lt;b&gt;ほかのひづめにもピンを打って&lt;/b&gt;ください（それぞれ 1 クリック）。Ctrl+Z でピンを 1 つ取り消せます。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click its nose&lt;/b&gt;, and &lt;b&gt;drag the new pin&lt;/b&gt; down to the ground. The shape flows along.</source>
        <translation>&lt;b&gt;鼻先をクリック&lt;/b&gt;し、地面まで&lt;b&gt;新しいピンをドラッグ&lt;/b&gt;してください。形状が滑らかについてきます。</translation>
    </message>
    <message>
        <source>What it keeps on the way is your choice: at the top right, under &lt;b&gt;Keep&lt;/b&gt;, &lt;b&gt;choose Area, Rigid or Angle&lt;/b&gt;, and see the neck change.</source>
        <translation>そのとき何を保つかは、自分で選べます。右上の&lt;b&gt;「保持」&lt;/b&gt;で&lt;b&gt;「面積」「剛体」「角度」のどれかを選び&lt;/b&gt;、首の変化を見てください。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press D&lt;/b&gt; to see in colours what the bend has changed, and where most. D again hides it.</source>
        <translation>&lt;b&gt;D を押す&lt;/b&gt;と、変形で何が変わり、どこが最も変わったかが色でわかります。もう一度 D を押すと隠れます。</translation>
    </message>
    <message>
        <source>The same for a part only: &lt;b&gt;press Ctrl+3&lt;/b&gt; for the step &lt;i&gt;Paint&lt;/i&gt;, and &lt;b&gt;brush over the neck&lt;/b&gt;. [ and ] change the size of the brush.</source>
        <translation>一部だけを変えることもできます。&lt;b&gt;Ctrl+3 を押して&lt;/b&gt;ステップ&lt;i&gt;「ペイント」&lt;/i&gt;に移り、&lt;b&gt;首をブラシでなぞって&lt;/b&gt;ください。[ と ] でブラシのサイズを変更します。</translation>
    </message>
    <message>
        <source>Your drag is already a film: &lt;b&gt;press K&lt;/b&gt; to play it. Click into the strip below to go to a time, and drag on from there.</source>
        <translation>ドラッグした動きは、もうムービーになっています。&lt;b&gt;K を押す&lt;/b&gt;と再生します。下の帯をクリックするとその時刻に移り、そこからドラッグを続けられます。</translation>
    </message>
    <message>
        <source>That is all you need to begin. &lt;b&gt;F1&lt;/b&gt; opens the manual, &lt;b&gt;?&lt;/b&gt; lists the keys. Drop a picture of your own on the window.</source>
        <translation>始めるのに必要なことは、これですべてです。&lt;b&gt;F1&lt;/b&gt; でマニュアル、&lt;b&gt;?&lt;/b&gt; でキーの一覧が開きます。自分の画像をウィンドウにドロップしてください。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>スキップ</translation>
    </message>
    <message>
        <source>Finally, &lt;b&gt;press Ctrl+5&lt;/b&gt; for the step &lt;i&gt;Export&lt;/i&gt;: a picture, a sequence, an ST map, or the mesh.</source>
        <translation>最後に、&lt;b&gt;Ctrl+5 を押して&lt;/b&gt;ステップ&lt;i&gt;「書き出し」&lt;/i&gt;に移ります。画像、連番、ST マップ、メッシュを書き出せます。</translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation>ソリッドのビュー</translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation>ソリッドを描画できません：%1</translation>
    </message>
</context>
<context>
    <name>wend::WorkNote</name>
    <message>
        <source>Cancel (Esc)</source>
        <translation>キャンセル (Esc)</translation>
    </message>
    <message>
        <source>Stops what is being computed and goes back to the last complete state</source>
        <translation>計算を中断し、最後に完了した状態に戻ります</translation>
    </message>
    <message>
        <source>Computing the motion: %1 %</source>
        <translation>モーションを計算しています：%1%</translation>
    </message>
    <message>
        <source>Meshing %1 …</source>
        <translation>%1 をメッシュ化しています…</translation>
    </message>
    <message numerus="yes">
        <source>Meshing %1 with about %Ln vertices …</source>
        <translation>
            <numerusform>%1 を約 %Ln 頂点でメッシュ化しています…</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Filling the ground behind “%1” …</source>
        <translation>「%1」の背後を塗りつぶしています…</translation>
    </message>
</context>
</TS>
