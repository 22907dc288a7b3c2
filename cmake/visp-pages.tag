<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- SPDX-License-Identifier: GPL-2.0-or-later -->
<!-- The pages of ViSP's own documentation that ours refer to. -->
<tagfile>
  <compound kind="page">
    <name>tutorial-tracking-mb-generic</name>
    <title>Tutorial: Markerless generic model-based tracking using a color camera</title>
    <filename>tutorial-tracking-mb-generic.html</filename>
  </compound>
</tagfile>
